#!/bin/sh
# step --kernel opencl: what is missing is said in a line, whatever it is; and
# where there is a device, tables are those of the portable kernel.
. tests/programs/common
step=build/bin/step
POCL_CACHE_DIR=$PWD/build/pocl
export POCL_CACHE_DIR
mkdir -p "$POCL_CACHE_DIR" "$work/lib"
build/bin/scene ring --particles 100 -o "$work/ring"
build/bin/scene figure-eight -o "$work/eight"

# Libraries that are none, or whose drivers or devices are not there.
LD_LIBRARY_PATH=$work/lib
export LD_LIBRARY_PATH
broken() { # PATTERN [KERNEL]
    refuses 2 "--kernel: opencl: .*$1" $step "$work/ring" --until 1 \
        --kernel "${2:-opencl}" -o "$work/table"
}
echo 'no library' | tee "$work/lib/libOpenCL.so" >"$work/lib/libOpenCL.so.1"
broken 'no library libOpenCL.so.1 is found; apt-get install'
# pretend SOURCE: a library of all its functions; those that are not given
# return 0, and NULL.
pretend() {
    {
        echo '#include <stdint.h>'
        echo '#include <string.h>'
        cat
        for name in GetPlatformIDs GetDeviceIDs GetDeviceInfo CreateContext \
            CreateCommandQueue CreateProgramWithSource BuildProgram \
            GetProgramBuildInfo CreateKernel CreateBuffer SetKernelArg \
            EnqueueWriteBuffer EnqueueReadBuffer EnqueueNDRangeKernel \
            ReleaseMemObject ReleaseKernel ReleaseProgram \
            ReleaseCommandQueue ReleaseContext; do
            echo "#ifndef cl$name"
            echo "void *cl$name(void) { return 0; }"
            echo '#endif'
        done
    } >"$work/cl.c"
    rm "$work/lib/"*
    ${CC:-cc} -shared -fPIC -w -o "$work/lib/libOpenCL.so.1" "$work/cl.c" ||
        not_ok 'a library' 'does not compile'
}
echo 'int no_function;' >"$work/cl.c"
rm "$work/lib/"*
${CC:-cc} -shared -fPIC -o "$work/lib/libOpenCL.so.1" "$work/cl.c"
broken 'libOpenCL.so.1 has no clGetPlatformIDs'
pretend <<'END'
#define clGetPlatformIDs clGetPlatformIDs
int clGetPlatformIDs(void) { return -1001; }
END
broken 'no driver of a device; for the processor: apt-get install'
one='#define clGetPlatformIDs clGetPlatformIDs
int clGetPlatformIDs(uint32_t n, void **p, uint32_t *found)
{ *p = p; *found = 1; return 0; }'
pretend <<END
$one
#define clGetDeviceIDs clGetDeviceIDs
int clGetDeviceIDs(void) { return -1; }
END
broken 'a driver, but no device'
# A device, which has no doubles unless the line says so.
device="$one
#define clGetDeviceIDs clGetDeviceIDs
int clGetDeviceIDs(void *p, uint64_t t, uint32_t n, void **d, uint32_t *found)
{ *d = p; *found = 1; return 0; }
#define clGetDeviceInfo clGetDeviceInfo
int clGetDeviceInfo(void *d, uint32_t what, size_t n, void *to, size_t *m)
{ if (what == 0x1000) *(uint64_t *)to = 4;
  if (what == 0x102B) strcpy(to, \"card\");
  if (what == 0x1030) strcpy(to, EXTENSIONS); return 0; }"
{ echo '#define EXTENSIONS ""'; echo "$device"; } | pretend
broken 'none of 1 devices has numbers of double precision; .*opencl-float'
broken 'card cannot be used (answer 0)' opencl-float
device="#define EXTENSIONS \"cl_khr_fp64\"
$device"
any='#define clCreateContext clCreateContext
void *clCreateContext(void) { return "x"; }
#define clCreateCommandQueue clCreateCommandQueue
void *clCreateCommandQueue(void) { return "x"; }
#define clCreateProgramWithSource clCreateProgramWithSource
void *clCreateProgramWithSource(void) { return "x"; }'
pretend <<END
$device
$any
#define clBuildProgram clBuildProgram
int clBuildProgram(void) { return -11; }
#define clGetProgramBuildInfo clGetProgramBuildInfo
int clGetProgramBuildInfo(void *p, void *d, uint32_t w, size_t n, void *to,
    size_t *m) { strcpy(to, "line 7: no"); return 0; }
END
broken 'card does not compile the program (answer -11): line 7: no'
ready="$device
$any
#define clCreateKernel clCreateKernel
void *clCreateKernel(void) { return \"x\"; }"
echo "$ready" | pretend
broken 'card does not take 101 bodies (answer 0)'
pretend <<END
$ready
#define clCreateBuffer clCreateBuffer
void *clCreateBuffer(void) { return "x"; }
#define clEnqueueNDRangeKernel clEnqueueNDRangeKernel
int clEnqueueNDRangeKernel(void) { return -5; }
END
refuses 1 '--kernel: opencl: after t = 0 card failed (answer -5)' \
    $step "$work/ring" --until 4 --kernel opencl -o "$work/table"
holds 'and the table has the row before' \
    test "$(grep -vc '^#' "$work/table")" = 1
unset LD_LIBRARY_PATH
refuses 2 'kernel: means nothing without gravity of more than 32' \
    $step "$work/eight" --until 1 --kernel opencl

# A device.
planned=11
if $step "$work/ring" --until 1 --kernel opencl -o "$work/t" 2>"$work/why"
then
    rows() { grep -v '^#' "$1"; }
    same() { # WHAT OPTION...
        what=$1
        shift
        for kernel in portable opencl; do
            $step "$work/ring" --until 40 --dt 2 "$@" --kernel $kernel \
                -o "$work/$kernel" --summary "$work/$kernel.key"
            rows "$work/$kernel" >"$work/rows-$kernel"
        done
        holds "$what: the bytes of the portable kernel" \
            cmp "$work/rows-portable" "$work/rows-opencl"
    }
    for method in $(methods); do
        same "$method" --method "$method"
    done
    same 'a method with steps of its own' --method radau15 --tolerance 1e-9
    holds 'the summary names it' grep -qx 'kernel opencl' "$work/opencl.key"
    $step "$work/ring" --until 40 --dt 2 --kernel opencl-float -o "$work/f" \
        --summary "$work/key"
    holds 'and opencl-float' grep -qx 'kernel opencl-float' "$work/key"
    planned=$((planned + $(methods | wc -l) + 3))
else
    echo "# note: no sums by OpenCL are tested: $(cat "$work/why")" \
        '(sh .ci/install opencl)'
    holds 'what is missing is said' grep -q '^step: --kernel: opencl: ' \
        "$work/why"
    planned=$((planned + 1))
fi
echo "1..$planned"
