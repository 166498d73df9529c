#include "image/taken_names.hpp"

#include <iterator>
#include <regex>
#include <set>
#include <sstream>

namespace flashbvh::tool {
namespace {

/// By their look: reserved for compilers; types; macros, those of vendors' headers, too, and M_PIf;
/// families of the standard headers.
constexpr const char* kTakenPattern =
    "_[A-Za-z_].*|.*_t|[A-Z][A-Z0-9_]*(f(16|32|64|128)?x?|l)?|(PRI|SCN)[bBdiouxX].*|.*_unlocked|"
    "(atomic|cnd|memory_order|mtx|posix|pthread|thrd|tss)_.*|"
    "f(32|64)x?(add|div|fma|mul|sqrt|sub)|(strfrom|strto|wcsto)f(32|64|128)x?(_l)?|"
    "lgamma[fl].*_r";

/// Forms of the same function for other types: sinf, sinl, sinf32x, stat64.
constexpr const char* kOtherType = "(f(16|32|64|128)?x?|l|64)$";

/// The keywords of C11, C++20 and GNU; macros that compilers predefine; and what glibc's and
/// newlib's headers declare and define: those of C11 whatever it is, those of POSIX in names of one
/// word.
constexpr const char* kTaken = R"(
L_ctermid L_cuserid L_tmpnam P_tmpdir a64l abi abort abs accept access acct acos acosh addrinfo
addseverity adjtime aiocb aioinit alarm alignas aligned_alloc alignof alloca alphasort and and_eq
arc4random arc4random_buf arc4random_uniform asctime asctime_r asin asinh asiprintf asm asniprintf
asnprintf asprintf assert assert_perror at_quick_exit atan atan2 atanh atexit atof atoi atol auto
basename bcmp bcopy be16toh be32toh be64toh bind bindresvport bintime bitand bitor bool break brk
bsearch btowc bttosbt bzero c16rtomb c32rtomb c8rtomb cabs cacos cacosh call_once calloc
canonicalize canonicalize_file_name carg case casin casinh catan catanh catch catclose catgets
catopen cbrt ccos ccosh ceil cexp cfgetispeed cfgetospeed cfmakeraw cfree cfsetispeed cfsetospeed
cfsetspeed char chdir chmod chown chroot cimag class clearenv clearerr clock clock_adjtime
clock_getcpuclockid clock_getres clock_gettime clock_nanosleep clock_settime clog clog10 clone
close close_range closedir closefrom closelog cmsghdr co_await co_return co_yield compl complex
concept confstr conj connect const const_cast consteval constexpr constinit continue
copy_file_range copysign cos cosh cpow cproj creal creat crypt csin csinh csqrt ctan ctanh ctermid
ctime ctime_r cuserid dadd daemon daylight ddiv decltype default delete dfma difftime diprintf
dirent dirfd dirname div dladdr dlclose dlerror dlinfo dlmopen dlopen dlsym dlvsym dmul do double
dprintf drand48 drand48_data drand48_r drem dsqrt dsub dup dup2 dup3 duplocale dynamic_cast dysize
eaccess ecvt ecvt_r eflock else encrypt endgrent endhostent endnetent endnetgrent endorder
endprotoent endpwent endrpcent endservent endusershell endutxent entry enum environ erand48
erand48_r erf erfc errno euidaccess execl execle execlp execlpe execv execve execveat execvp
execvpe exit exp exp10 exp2 explicit explicit_bzero expm1 export extern f32addf32x f32addf64
f32addf64x f32divf32x f32divf64 f32divf64x f32fmaf32x f32fmaf64 f32fmaf64x f32mulf32x f32mulf64
f32mulf64x f32sqrtf32x f32sqrtf64 f32sqrtf64x f32subf32x f32subf64 f32subf64x f32xaddf64
f32xaddf64x f32xdivf64 f32xdivf64x f32xfmaf64 f32xfmaf64x f32xmulf64 f32xmulf64x f32xsqrtf64
f32xsqrtf64x f32xsubf64 f32xsubf64x f64addf64x f64divf64x f64fmaf64x f64mulf64x f64sqrtf64x
f64subf64x fabs faccessat fadd fallocate false fast_putc fchdir fchmod fchmodat fchown fchownat
fclose fcloseall fcntl fcvt fcvt_r fd_mask fd_set fdatasync fdim fdiv fdopen fdopendir
feclearexcept fedisableexcept feenableexcept fegetenv fegetexcept fegetexceptflag fegetmode
fegetround feholdexcept feof feraiseexcept ferror fesetenv fesetexcept fesetexceptflag fesetmode
fesetround fetestexcept fetestexceptflag feupdateenv fexecve fflush ffma ffs ffsll fgetc fgetgrent
fgetgrent_r fgetpos fgetpwent fgetpwent_r fgets fgetwc fgetws fileno finite fiprintf fiscanf
flashbvh float flock flockfile floor fls flsll fma fmax fmaximum fmaximum_mag fmaximum_mag_num
fmaximum_num fmaxmag fmemopen fmin fminimum fminimum_mag fminimum_mag_num fminimum_num fminmag fmod
fmtmsg fmul fnmatch fopen fopencookie for fork fortran fpathconf fpclassify fprintf fpurge fputc
fputs fputwc fputws fread free freeaddrinfo freelocale freopen frexp friend fromfp fromfpx fropen
fscanf fseek fseeko fsetpos fsqrt fstat fstatat fstatvfs fsub fsync ftell ftello ftok ftruncate
ftrylockfile ftw funlockfile funopen futimens futimes futimesat fwide fwopen fwprintf fwrite
fwscanf gaicb gamma gamma_r gammaf_r gcvt get_current_dir_name getaddrinfo getc getchar getcpu
getcwd getdate getdate_err getdate_r getdelim getdirentries getdomainname getdtablesize getegid
getentropy getenv geteuid getgid getgrent getgrent_r getgrgid getgrgid_r getgrnam getgrnam_r
getgrouplist getgroups gethostbyaddr gethostbyaddr_r gethostbyname gethostbyname_r gethostent
gethostent_r gethostid gethostname getitimer getline getloadavg getlogin getlogin_r getnameinfo
getnetbyaddr getnetbyaddr_r getnetbyname getnetbyname_r getnetent getnetent_r getnetgrent
getnetgrent_r getopt getpagesize getpass getpayload getpeereid getpeername getpgid getpgrp getpid
getppid getpriority getprotobyname getprotobyname_r getprotobynumber getprotobynumber_r getprotoent
getprotoent_r getpt getpw getpwent getpwent_r getpwnam getpwnam_r getpwuid getpwuid_r getresgid
getresuid getrlimit getrpcbyname getrpcbyname_r getrpcbynumber getrpcbynumber_r getrpcent
getrpcent_r getrusage gets getservbyname getservbyname_r getservbyport getservbyport_r getservent
getservent_r getsid getsockname getsockopt getsourcefilter getsubopt gettid gettimeofday getuid
getumask getusershell getutmp getutmpx getutxent getutxid getutxline getw getwc getwchar getwd glob
globfree gmtime gmtime_r goto grantpt group group_member gsignal hcreate hcreate_r hdestroy
hdestroy_r herror hostent hsearch hsearch_r hstrerror htobe16 htobe32 htobe64 htole16 htole32
htole64 htonl htons hypot i386 iconv if ifaddr ifconf ifmap ifreq ilogb imaxabs imaxdiv index
infinity initgroups initstate initstate_r inline innetgr insque int iovec iprintf iruserok isalnum
isalnum_l isalpha isalpha_l isascii isascii_l isatty isblank isblank_l iscanf iscanonical iscntrl
iscntrl_l isctype isdigit isdigit_l iseqsig isfdtype isfinite isgraph isgraph_l isgreater
isgreaterequal isinf isless islessequal islessgreater islower islower_l isnan isnormal isprint
isprint_l ispunct ispunct_l issetugid issignaling isspace isspace_l issubnormal isunordered isupper
isupper_l iswalnum iswalnum_l iswalpha iswalpha_l iswblank iswblank_l iswcntrl iswcntrl_l iswctype
iswctype_l iswdigit iswdigit_l iswgraph iswgraph_l iswlower iswlower_l iswprint iswprint_l iswpunct
iswpunct_l iswspace iswspace_l iswupper iswupper_l iswxdigit iswxdigit_l isxdigit isxdigit_l iszero
itimerspec itimerval itoa j0 j1 jmp_buf jn jrand48 jrand48_r kill kill_dependency killpg l64a labs
lchmod lchown lcong48 lcong48_r lconv ldexp ldiv le16toh le32toh le64toh leaf lfind lgamma lgamma_r
linger link linkat linux listen llabs lldiv llogb llrint llround localeconv localtime localtime_r
lockf lockf64 log log10 log1p log2 logb long longjmp lrand48 lrand48_r lrint lround lsearch lseek
lstat lutimes madvise main mallinfo malloc mallopt math_errhandling mblen mbrlen mbrtoc16 mbrtoc32
mbrtoc8 mbrtowc mbsinit mbsnrtowcs mbsrtowcs mbstowcs mbtowc memalign memccpy memchr memcmp memcpy
memfrob memmem memmove memory_order mempcpy memrchr memset mincore mips mkdir mkdirat mkdtemp
mkfifo mkfifoat mknod mknodat mkostemp mkostemps mkstemp mkstemps mktemp mktime mlock mlockall mmap
mmsghdr modf mprotect mrand48 mrand48_r mremap msgbuf msgctl msgget msghdr msginfo msgrcv msgsnd
mstats mstosbt msync munlock munlockall munmap mutable namespace nan nanosleep nearbyint netent new
newlocale nextafter nextdown nexttoward nextup nftw nice noexcept noreturn not not_eq nrand48
nrand48_r nstosbt ntohl ntohs nullptr obstack obstack_printf obstack_vprintf offsetof on_exit
once_flag open open_memstream open_wmemstream openat opendir openlog operator optarg opterr optind
optopt optreset or or_eq osockaddr passwd pathconf pause pclose perror physadr pipe pipe2 poll
pollfd popen posix postorder pow pow10 ppoll pread preadv preorder printf private prlimit profil
program_invocation_name program_invocation_short_name protected protoent pselect psiginfo psignal
ptsname ptsname_r public putc putchar putenv putgrent putpwent puts pututxline putw putwc putwchar
pvalloc pwrite pwritev qecvt qecvt_r qelem qfcvt qfcvt_r qgcvt qsort qsort_r quad quick_exit raise
rand rand_r random random_data random_r rawmemchr rcmd read readahead readdir readdir_r readlink
readlinkat readv realloc reallocarray realpath recv recvfrom recvmmsg recvmsg regcomp regerror
regexec regfree register reinterpret_cast remainder remove remque remquo rename renameat renameat2
requires restrict return revoke rewind rewinddir rexec rindex rint riscv rlimit rmdir round
roundeven rpcent rpmatch rresvport rusage ruserok sa_handler sa_sigaction sbrk sbttobt sbttoms
sbttons sbttots sbttotv sbttous scalb scalbln scalbn scandir scandirat scanf sched_param
secure_getenv seed48 seed48_r seekdir select sembuf semctl semget seminfo semop semtimedop send
sendmmsg sendmsg sendto servent setbuf setbuffer setdomainname setdtablesize setegid setenv seteuid
setgid setgrent setgroups sethostent sethostid sethostname setitimer setjmp setkey setlinebuf
setlocale setlogin setlogmask setnetent setnetgrent setns setpassent setpayload setpayloadsig
setpgid setpgrp setpriority setprotoent setpwent setregid setresgid setresuid setreuid setrlimit
setrpcent setservent setsid setsockopt setsourcefilter setstate setstate_r settimeofday setuid
setusershell setutxent setvbuf shmat shmctl shmdt shmget shminfo short shutdown si_addr si_addr_lsb
si_arch si_band si_call_addr si_fd si_int si_lower si_overrun si_pid si_pkey si_ptr si_status
si_stime si_syscall si_timerid si_uid si_upper si_utime si_value sigabbrev_np sigaction sigaddset
sigaltstack sigandset sigblock sigcontext sigdelset sigdescr_np sigemptyset sigev_notify_attributes
sigev_notify_function sigevent sigfillset siggetmask sighold sigignore siginterrupt sigisemptyset
sigismember sigjmp_buf siglongjmp sigmask signal signbit signed signgam significand sigorset
sigpause sigpending sigprocmask sigqueue sigrelse sigreturn sigset sigsetjmp sigsetmask sigstack
sigsuspend sigtimedwait sigval sigwait sigwaitinfo sin sincos sinh siprintf siscanf sizeof sleep
sniprintf snprintf sockaddr sockatmark socket socketpair sparc splice sprintf sqrt srand srand48
srand48_r srandom srandom_r sscanf ssignal stat static static_assert static_cast statvfs statx std
stderr stdin stdout stpcpy stpncpy strcasecmp strcasecmp_l strcasestr strcat strchr strchrnul
strcmp strcoll strcoll_l strcpy strcspn strdup strdupa strerror strerror_l strerror_r
strerrordesc_np strerrorname_np strfmon strfmon_l strfromd strfromf strfroml strfry strftime
strftime_l strlcat strlcpy strlen strlwr strncasecmp strncasecmp_l strncat strncmp strncpy strndup
strndupa strnlen strnstr strpbrk strptime strptime_l strrchr strsep strsignal strspn strstr strtod
strtod_l strtof strtof_l strtoimax strtoimax_l strtok strtok_r strtol strtol_l strtold strtold_l
strtoll_l strtoq strtoul strtoul_l strtoull_l strtoumax strtoumax_l strtouq struct strupr
strverscmp strxfrm strxfrm_l suboptarg sun swab switch swprintf swscanf symlink symlinkat sync
syncfs syscall sysconf syslog system sysv_signal tan tanh tcdrain tcflow tcflush tcgetattr
tcgetpgrp tcgetsid tcphdr tcsendbreak tcsetattr tcsetpgrp tdelete tdestroy tee telldir template
tempnam termios tfind tgamma tgkill this thread_local throw time timegm timelocal timer_create
timer_delete timer_getoverrun timer_gettime timer_settime timeradd timerclear timercmp timerisset
timersub times timespec timespec_get timespec_getres timespecadd timespecclear timespeccmp
timespecisset timespecsub timeval timex timezone timingsafe_bcmp timingsafe_memcmp tm tmpfile
tmpnam tmpnam_r tms toascii toascii_l tolower tolower_l totalorder totalordermag toupper toupper_l
towctrans towctrans_l towlower towlower_l towupper towupper_l true trunc truncate try tsearch
tstosbt ttyname ttyname_r ttyslot tvtosbt twalk twalk_r typedef typeid typename typeof
typeof_unqual tzname tzset u_char u_int u_long u_short ualarm ucred ufromfp ufromfpx uint ulimit
ulong umask uname ungetc ungetwc union unix unlink unlinkat unlockpt unsetenv unshare unsigned
updwtmpx uselocale ushort using usleep ustosbt utimbuf utime utimensat utimes utmp utmpx utmpxname
utoa utsname va_arg va_copy va_end va_list va_start valloc vasiprintf vasniprintf vasnprintf
vasprintf vax vdiprintf vdprintf versionsort vfiprintf vfiscanf vfork vfprintf vfscanf vfwprintf
vfwscanf vhangup viprintf virtual viscanf vmsplice void volatile vprintf vscanf vsiprintf vsiscanf
vsniprintf vsnprintf vsprintf vsscanf vswprintf vswscanf vsyslog vwprintf vwscanf wait waitid
waitpid wcpcpy wcpncpy wcrtomb wcscasecmp wcscasecmp_l wcscat wcschr wcschrnul wcscmp wcscoll
wcscoll_l wcscpy wcscspn wcsdup wcsftime wcsftime_l wcslcat wcslcpy wcslen wcsncasecmp
wcsncasecmp_l wcsncat wcsncmp wcsncpy wcsnlen wcsnrtombs wcspbrk wcsrchr wcsrtombs wcsspn wcsstr
wcstod wcstod_l wcstof wcstof_l wcstoimax wcstoimax_l wcstok wcstol wcstol_l wcstold wcstold_l
wcstoll_l wcstombs wcstoq wcstoul wcstoul_l wcstoull_l wcstoumax wcstoumax_l wcstouq wcswcs
wcswidth wcsxfrm wcsxfrm_l wctob wctomb wctrans wctrans_l wctype wctype_l wcwidth while wmemchr
wmemcmp wmemcpy wmemmove wmempcpy wmemset wordexp wordfree wprintf write writev wscanf xor xor_eq
y0 y1 yn
)";

std::set<std::string> words_of(const char* text) {
  std::istringstream words(text);
  return {std::istream_iterator<std::string>(words), std::istream_iterator<std::string>()};
}

}  // namespace

bool is_taken(const std::string& name) {
  static const std::set<std::string> taken = words_of(kTaken);
  static const std::regex pattern(kTakenPattern);
  static const std::regex other_type(kOtherType);
  const auto takes = [&](const std::string& word) {
    return taken.count(word) != 0 || std::regex_match(word, pattern);
  };
  return takes(name) || takes(std::regex_replace(name, other_type, ""));
}

}  // namespace flashbvh::tool
