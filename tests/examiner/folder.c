/* Trees that are hard to remove: deep ones, closed ones, links that lead
   out, names that a shell would take for its own. */
#include "examiner/folder.h"
#define UNIT_OWN_MAIN
#include "unit.h"

#include <errno.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

static char top[64];

/* Makes a folder with a name for each test, and opens it. */
static int begin(const char *name)
{
    strcpy(top, name);
    UNIT_TRUE(mkdir(top, 0700) == 0);
    return open(top, O_RDONLY | O_DIRECTORY);
}

static void make_file(int folder, const char *name)
{
    const int file = openat(folder, name, O_WRONLY | O_CREAT, 0600);
    UNIT_TRUE(file >= 0);
    close(file);
}

static bool is_there(const char *path)
{
    struct stat about;
    return lstat(path, &about) == 0;
}

/* The path of the last of these folders has 6000 signs, which no system
   call takes; in each of them is a file, too. */
TEST(test_deep, "a tree of any depth goes")
{
    int folder = begin("it's deep");
    for (int i = 0; i < 3000; ++i) {
        make_file(folder, "f");
        UNIT_TRUE(mkdirat(folder, "d", 0700) == 0);
        const int inner = openat(folder, "d", O_RDONLY | O_DIRECTORY);
        close(folder);
        folder = inner;
    }
    close(folder);
    UNIT_TRUE(folder_remove(top));
    UNIT_TRUE(!is_there(top));
}

/* Names that folders get when they are moved to the top are taken, by files
   and by folders with something in them. */
TEST(test_numbers, "taken names do no harm")
{
    char name[32];
    const int folder = begin("numbers $(exit 1)");
    UNIT_TRUE(mkdirat(folder, "a", 0700) == 0);
    for (int i = 1; i < 40; ++i) {
        snprintf(name, sizeof name, "%d", i);
        if (i % 2) {
            make_file(folder, name);
        } else {
            UNIT_TRUE(mkdirat(folder, name, 0700) == 0);
            snprintf(name, sizeof name, "%d/x", i);
            make_file(folder, name);
        }
        snprintf(name, sizeof name, "a/%d", i);
        UNIT_TRUE(mkdirat(folder, name, 0700) == 0);
        snprintf(name, sizeof name, "a/%d/x", i);
        make_file(folder, name);
    }
    close(folder);
    UNIT_TRUE(folder_remove(top));
    UNIT_TRUE(!is_there(top));
}

/* Who may do nothing in a folder of his own may still remove it. (Root may
   do all, and proves nothing here.) */
TEST(test_closed, "closed folders go")
{
    const int folder = begin("closed");
    UNIT_TRUE(mkdirat(folder, "a", 0700) == 0);
    UNIT_TRUE(mkdirat(folder, "a/b", 0700) == 0);
    make_file(folder, "a/b/c");
    UNIT_TRUE(fchmodat(folder, "a/b", 0, 0) == 0);
    UNIT_TRUE(fchmodat(folder, "a", 0, 0) == 0);
    UNIT_TRUE(fchmod(folder, 0) == 0);
    close(folder);
    UNIT_TRUE(folder_remove(top));
    UNIT_TRUE(!is_there(top));
}

TEST(test_links, "links are not followed")
{
    UNIT_TRUE(mkdir("outside", 0700) == 0);
    UNIT_TRUE(mkdir("outside/kept", 0700) == 0);
    const int folder = begin("links");
    UNIT_TRUE(symlinkat("../outside", folder, "out") == 0);
    UNIT_TRUE(symlinkat("nowhere", folder, "lost") == 0);
    UNIT_TRUE(symlinkat(".", folder, "here") == 0);
    close(folder);
    UNIT_TRUE(folder_remove(top));
    UNIT_TRUE(!is_there(top));
    UNIT_TRUE(is_there("outside/kept"));
    UNIT_TRUE(symlink("outside", "link") == 0);
    UNIT_TRUE(!folder_remove("link"));
    UNIT_TRUE(is_there("outside/kept"));
    UNIT_TRUE(!folder_remove("nothing") && errno == ENOENT);
    UNIT_TRUE(unlink("link") == 0 && folder_remove("outside"));
}

int main(void)
{
    char scratch[] = "build/tests/folder.XXXXXX";
    if (!mkdtemp(scratch) || chdir(scratch) != 0)
        return EXIT_FAILURE;
    const int failed = unit_run("folder");
    if (chdir("../../..") != 0 || rmdir(scratch) != 0)
        return EXIT_FAILURE;
    return failed;
}
