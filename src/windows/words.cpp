// The words of a command are what was written: the C library of mingw-w64 puts no names of files for * and ?.
extern "C" {
int _CRT_glob = 0;
}
