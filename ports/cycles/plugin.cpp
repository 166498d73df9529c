// A QEMU plugin that counts the cycles of a Cortex-M by a model (lib/docs/cycles.md).
//
//     -plugin FILE,tables=FOLDER,core=NAME,result=FILE[,range=least|most]
//             [,flash=NAME,flash_begin=ADDRESS,flash_kb=N]
//
// The guest marks counted code by calls of port_cycles_begin and port_cycles_end. After each pair
// the plugin writes the file `result`, which the guest reads (ports/common/cycles.cpp) and which is
// removed when QEMU ends. A block's cycles are computed once, when QEMU translates it; each
// execution adds them and the cycles of a jump.
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <map>
#include <memory>
#include <string>

#include "flash.hpp"
#include "pipeline.hpp"
#include "qemu_plugin.h"
#include "table.hpp"
#include "thumb.hpp"

int qemu_plugin_version = 1;

namespace cycles {
namespace {

enum class Mark : uint8_t { none, begin, end };

struct Block {
  uint64_t first = 0;
  uint64_t after = 0;   ///< next address if the last instruction does not jump
  uint32_t cycles = 0;  ///< without a jump at its end
  uint32_t jump = 0;
  uint32_t entry = 0;  ///< in addition, if entered by a jump
  Mark mark = Mark::none;
};

struct Model {
  Table table;
  std::unique_ptr<Flash> flash;
  std::deque<Block> blocks;          ///< never move, as QEMU has their addresses
  std::map<uint64_t, Pipeline> cut;  ///< states after blocks that end without a jump
  const Block* last = nullptr;
  uint64_t cycles = 0;
  uint64_t begun = 0;
  uint32_t pairs = 0;
  std::string result_name;
  int result = -1;
};

Model model;

/// The layout that the guest reads (ports/common/cycles.cpp).
struct Result {
  uint32_t cycles;
  uint32_t pairs;
};

void put_result() {
  model.pairs += 1;
  const Result result = {static_cast<uint32_t>(model.cycles - model.begun), model.pairs};
  if (pwrite(model.result, &result, sizeof result, 0) != sizeof result) {
    std::perror("[cycles] cannot write the result");
    std::exit(1);
  }
}

void enter(unsigned, void* data) {
  const Block& block = *static_cast<const Block*>(data);
  if (model.last != nullptr && model.last->after != block.first) {
    model.cycles += model.last->jump + block.entry;
  }
  model.last = &block;
  if (block.mark == Mark::begin) {
    model.begun = model.cycles;
  } else if (block.mark == Mark::end) {
    put_result();
  }
  if (model.flash) {
    model.cycles += model.flash->fetch(block.first, block.after, model.cycles, block.cycles);
  }
  model.cycles += block.cycles;
}

void read_data(unsigned, qemu_plugin_meminfo_t info, uint64_t address, void*) {
  if (!qemu_plugin_mem_is_store(info)) {
    model.cycles += model.flash->load(address);
  }
}

Instruction decode(const qemu_plugin_insn* code) {
  uint16_t halves[2] = {};
  std::memcpy(halves, qemu_plugin_insn_data(code), qemu_plugin_insn_size(code));
  return cycles::decode(halves[0], halves[1]);
}

Mark mark_of(const qemu_plugin_insn* code) {
  static uint64_t begin = 0;
  static uint64_t end = 0;
  const char* const symbol = qemu_plugin_insn_symbol(code);
  if (symbol == nullptr) {
    return Mark::none;
  }
  // The first block of a function that is translated is its entry.
  const uint64_t address = qemu_plugin_insn_vaddr(code);
  const bool is_begin = std::strcmp(symbol, "port_cycles_begin") == 0;
  if (!is_begin && std::strcmp(symbol, "port_cycles_end") != 0) {
    return Mark::none;
  }
  uint64_t& entry = is_begin ? begin : end;
  entry = entry == 0 ? address : entry;
  return entry != address ? Mark::none : is_begin ? Mark::begin : Mark::end;
}

void refuse(const Instruction& instruction, uint64_t address) {
  std::fprintf(
      stderr,
      "[cycles] core=: the table has no row '%s', for the instruction at 0x%llx; give the table "
      "of the core that the program is built for\n",
      name_of(instruction.kind), static_cast<unsigned long long>(address));
  std::exit(1);
}

void end(qemu_plugin_id_t, void*) {
  std::remove(model.result_name.c_str());
}

void add(const qemu_plugin_tb* translated, size_t i, Pipeline& pipeline, Block& block) {
  qemu_plugin_insn* const code = qemu_plugin_tb_get_insn(translated, i);
  const uint64_t address = qemu_plugin_insn_vaddr(code);
  Instruction instruction = decode(code);
  instruction.is_split = instruction.bytes == 4 && address % 4 != 0;
  const Row& row = model.table[instruction.kind];
  if (!model.table.has(instruction.kind)) {
    refuse(instruction, address);
  }
  block.cycles += pipeline.add(instruction);
  block.after = address + instruction.bytes;
  block.jump = row.jump;
  if (i == 0 && instruction.is_split) {
    block.entry = model.table[Rule::wide_target];
  }
  if (pipeline.may_be_skipped() && row.per_word != 0 && instruction.words != 0) {
    qemu_plugin_register_vcpu_mem_inline(code, QEMU_PLUGIN_MEM_RW, QEMU_PLUGIN_INLINE_ADD_U64,
                                         &model.cycles, row.per_word);
  }
  if (model.flash && instruction.words != 0) {
    // Registered for loads alone, QEMU 7.2 reports the stores.
    qemu_plugin_register_vcpu_mem_cb(code, read_data, QEMU_PLUGIN_CB_NO_REGS, QEMU_PLUGIN_MEM_RW,
                                     nullptr);
  }
}

/// The pipeline's state at a block's begin, since QEMU cuts code at the ends of pages.
Pipeline pipeline_at(uint64_t address) {
  const auto cut = model.cut.find(address);
  return cut == model.cut.end() ? Pipeline(model.table) : cut->second;
}

void translate(qemu_plugin_id_t, qemu_plugin_tb* translated) {
  Block& block = model.blocks.emplace_back();
  const qemu_plugin_insn* const first = qemu_plugin_tb_get_insn(translated, 0);
  block.first = qemu_plugin_insn_vaddr(first);
  Pipeline pipeline = pipeline_at(block.first);
  const size_t count = qemu_plugin_tb_n_insns(translated);
  for (size_t i = 0; i < count; ++i) {
    add(translated, i, pipeline, block);
  }
  if (block.jump == 0) {
    model.cut.emplace(block.after, pipeline);
  }
  block.mark = mark_of(first);
  qemu_plugin_register_vcpu_tb_exec_cb(translated, enter, QEMU_PLUGIN_CB_NO_REGS, &block);
}

using Arguments = std::map<std::string, std::string>;

Arguments read_arguments(int count, char** arguments) {
  Arguments read;
  for (int i = 0; i < count; ++i) {
    const std::string argument = arguments[i];
    const size_t equals = argument.find('=');
    read[argument.substr(0, equals)] =
        equals == std::string::npos ? "" : argument.substr(equals + 1);
  }
  return read;
}

std::string path_of(const Arguments& arguments, const std::string& table) {
  const auto folder = arguments.find("tables");
  std::string path = folder == arguments.end() ? "." : folder->second;
  return path.append("/").append(table).append(".csv");
}

uint64_t number_in(const std::string& argument) {
  return std::strtoull(argument.c_str(), nullptr, 0);
}

std::string set_flash(Arguments& arguments) {
  const std::string& name = arguments["flash"];
  if (name.empty()) {
    return "";
  }
  FlashProfile profile;
  std::string wrong = Flash::read(path_of(arguments, "flash"), name, profile);
  if (wrong.empty()) {
    model.flash = std::make_unique<Flash>(profile, number_in(arguments["flash_begin"]),
                                          number_in(arguments["flash_kb"]) * 1024);
  }
  return wrong;
}

std::string set_table(Arguments& arguments) {
  const std::string& range = arguments["range"];
  if (!range.empty() && range != "least" && range != "most") {
    return "range=" + range + ": give least or most, or nothing for what is assumed";
  }
  return model.table.read(path_of(arguments, arguments["core"]), range.empty()      ? Range::assumed
                                                                 : range == "least" ? Range::least
                                                                                    : Range::most);
}

std::string set_result(const std::string& name) {
  model.result_name = name;
  model.result = open(name.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
  return model.result < 0 ? "result=" + name + ": cannot be written" : "";
}

std::string set_up(Arguments arguments) {
  std::string wrong = set_table(arguments);
  if (wrong.empty()) {
    wrong = set_flash(arguments);
  }
  return wrong.empty() ? set_result(arguments["result"]) : wrong;
}

}  // namespace
}  // namespace cycles

int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t*, int count, char** arguments) {
  const std::string wrong = cycles::set_up(cycles::read_arguments(count, arguments));
  if (!wrong.empty()) {
    std::fprintf(stderr, "[cycles] %s\n", wrong.c_str());
    return 1;
  }
  qemu_plugin_register_vcpu_tb_trans_cb(id, cycles::translate);
  qemu_plugin_register_atexit_cb(id, cycles::end, nullptr);
  return 0;
}
