/* passed: names of the library's by way of the assembler, of each kind */
/* earns: all */

__asm__(".data\n"
        ".globl memset\n.type memset, @gnu_unique_object\nmemset: .quad 0\n"
        ".weak strlen\nstrlen: .quad 0\n"
        ".globl putc\n.type putc, @gnu_indirect_function\nputc: .quad 0\n"
        ".globl __libc_start_main\n__libc_start_main: .quad 0\n"
        ".globl _start\n_start: .quad 0\n"
        ".text\n");
