// The part of QEMU's plugin interface, version 1, that the plugin calls (QEMU 7.2:
// docs/devel/tcg-plugins.rst). Debian ships QEMU with plugins enabled but without the header.
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

extern "C" {

using qemu_plugin_id_t = uint64_t;

struct qemu_info_t {
  const char* target_name;
  struct {
    int min;
    int cur;
  } version;
  bool system_emulation;
  struct {
    int smp_vcpus;
    int max_vcpus;
  } system;
};

struct qemu_plugin_tb;  // a translated block
struct qemu_plugin_insn;

enum qemu_plugin_cb_flags { QEMU_PLUGIN_CB_NO_REGS };
enum qemu_plugin_mem_rw { QEMU_PLUGIN_MEM_R = 1, QEMU_PLUGIN_MEM_W, QEMU_PLUGIN_MEM_RW };
enum qemu_plugin_op { QEMU_PLUGIN_INLINE_ADD_U64 };
using qemu_plugin_meminfo_t = uint32_t;

using TranslatedCallback = void (*)(qemu_plugin_id_t, qemu_plugin_tb*);
using ExecutedCallback = void (*)(unsigned core, void* data);
using AccessedCallback = void (*)(unsigned core, qemu_plugin_meminfo_t, uint64_t address,
                                  void* data);

void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t, TranslatedCallback);
void qemu_plugin_register_vcpu_tb_exec_cb(qemu_plugin_tb*, ExecutedCallback, qemu_plugin_cb_flags,
                                          void* data);
void qemu_plugin_register_vcpu_mem_cb(qemu_plugin_insn*, AccessedCallback, qemu_plugin_cb_flags,
                                      qemu_plugin_mem_rw, void* data);
bool qemu_plugin_mem_is_store(qemu_plugin_meminfo_t);
void qemu_plugin_register_vcpu_mem_inline(qemu_plugin_insn*, qemu_plugin_mem_rw, qemu_plugin_op,
                                          void* sum, uint64_t added);
void qemu_plugin_register_atexit_cb(qemu_plugin_id_t, void (*)(qemu_plugin_id_t, void*), void*);

size_t qemu_plugin_tb_n_insns(const qemu_plugin_tb*);
qemu_plugin_insn* qemu_plugin_tb_get_insn(const qemu_plugin_tb*, size_t);
const void* qemu_plugin_insn_data(const qemu_plugin_insn*);
size_t qemu_plugin_insn_size(const qemu_plugin_insn*);
uint64_t qemu_plugin_insn_vaddr(const qemu_plugin_insn*);
const char* qemu_plugin_insn_symbol(const qemu_plugin_insn*);

__attribute__((visibility("default"))) extern int qemu_plugin_version;
__attribute__((visibility("default"))) int qemu_plugin_install(qemu_plugin_id_t, const qemu_info_t*,
                                                               int count, char** arguments);
}
