/* Writes a scene of the gallery with the values given to its keys. */
#include "scenes/gallery.h"
#include "scenes/scene.h"
#include "toolbox/program.h"
#include "toolbox/version.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PROGRAM "scene"

static const struct gallery_scene *const lists[] = {
    celestial_scenes, elastic_scenes, hard_scenes};
enum { LISTS = sizeof lists / sizeof lists[0] };

static const struct gallery_scene *find_scene(const char *name)
{
    const struct gallery_scene *g = NULL;
    for (size_t i = 0; i < LISTS && !g; ++i)
        g = gallery_find(lists[i], name);
    return g;
}

static char text[8192]; /* text of --help without a scene */

static void append(const char *format, ...)
{
    const size_t used = strlen(text);
    va_list values;
    va_start(values, format);
    vsnprintf(text + used, sizeof text - used, format, values);
    va_end(values);
}

/* Appends the names of a scene's keys in lines of at most 76 columns. */
static void append_keys(const struct gallery_scene *g)
{
    const size_t margin = 20, most = 76;
    size_t column = most;
    for (size_t k = 0; g->key[k].name; ++k) {
        const size_t width = strlen(g->key[k].name) + 3;
        if (column + width > most) {
            append("\n%*s", (int)margin, "");
            column = margin;
        }
        append(" --%s", g->key[k].name);
        column += width;
    }
}

static const char *describe_all(void)
{
    append("Write a scene to a file for step.\n\n"
           "NAME is one of these scenes, and comes first; NAME --help "
           "explains\n"
           "its keys, the options of that scene alone:");
    for (size_t i = 0; i < LISTS; ++i)
        for (const struct gallery_scene *g = lists[i]; g->name; ++g) {
            append("\n  %-18s %s", g->name, g->about);
            append_keys(g);
        }
    return text;
}

/* Prints an error with a list of all scenes and ends the program. */
_Noreturn static void refuse_name(const char *name)
{
    fprintf(stderr, PROGRAM ": '%s' is no scene; there are", name);
    for (size_t i = 0; i < LISTS; ++i)
        for (const struct gallery_scene *g = lists[i]; g->name; ++g)
            fprintf(stderr, "%s %s", i > 0 || g != lists[0] ? "," : "",
                    g->name);
    fprintf(stderr, "\n");
    exit(OPTIONS_FAILURE);
}

enum { FIRST_KEY = 2, ENTRIES = FIRST_KEY + GALLERY_KEYS + 1 };

/* Fills the table of options: --output, the name of the scene, and one
   option per key of the scene. The help of a key ends with its default. The
   entries point into `help`, so the caller must keep that array. */
static void make_entries(const struct gallery_scene *g,
                         struct options_entry entries[ENTRIES],
                         char help[GALLERY_KEYS][160])
{
    memset(entries, 0, ENTRIES * sizeof entries[0]);
    entries[0] = (struct options_entry){
        "output", 'o' | OPTIONS_SILENT | OPTIONS_WRITES, "FILE",
        "write to FILE (default: standard output)"};
    entries[1] = (struct options_entry){"", 0, "NAME", ""};
    for (size_t k = 0; g && g->key[k].name; ++k) {
        const struct gallery_key *key = &g->key[k];
        snprintf(help[k], sizeof help[k], "%s (usual %.10g)", key->help,
                 key->usual);
        entries[FIRST_KEY + k] = (struct options_entry){
            key->name, 0, key->whole ? "N" : "X", help[k]};
    }
}

struct settings {
    const struct gallery_scene *scene;
    double value[GALLERY_KEYS + 1];
    const char *output, *command;
};

/* Reads the value of key k. The value must be in the range of the key, and
   an integer if the key is whole. */
static void read_key(struct settings *s, struct options *o, size_t k)
{
    const struct gallery_key *key = &s->scene->key[k];
    if (key->whole)
        s->value[k] = (double)options_count(o, (uint64_t)key->low,
                                            (uint64_t)key->high);
    else
        s->value[k] = options_real(o, key->low, key->high);
}

/* Refuses an option that has no effect because another key is 0. */
static void refuse_unused(const struct settings *s, struct options *o)
{
    static const char *const parts[][4] = {
        {"ring", "moon", "moon-distance", "without --moon"},
        {"break", "jitter", "seed", "without --jitter"}};
    for (size_t k = 0; k < sizeof parts / sizeof parts[0]; ++k)
        if (strcmp(s->scene->name, parts[k][0]) == 0 &&
            s->value[gallery_key(s->scene, parts[k][1])] == 0)
            options_refuse(o, parts[k][2], parts[k][3]);
}

static void read_options(struct settings *s, struct options *o)
{
    int names = 0;
    for (int code; (code = options_next(o)) != -1;)
        if (code == 'o')
            s->output = options_text(o);
        else if (code >= OPTIONS_LONG + FIRST_KEY)
            read_key(s, o, (size_t)(code - OPTIONS_LONG - FIRST_KEY));
        else if (++names > 1 || !s->scene)
            options_fail(o, "'%s': the name of one scene comes first",
                         options_text(o));
    if (!s->scene)
        options_fail(o, "which scene? see " PROGRAM " --help");
    s->command = options_command(o);
    refuse_unused(s, o);
}

/* Writes the command and the values of all keys, including defaults. */
static void write_head(const struct settings *s, struct table *out)
{
    const struct gallery_scene *g = s->scene;
    table_print(out, "# " PROGRAM " (Bonkers) %s\n# command: %s\n",
                TOOLBOX_VERSION, s->command);
    table_print(out, "# %s: %s\n", g->name, g->about);
    for (size_t k = 0; g->key[k].name; ++k)
        table_print(out, "# --%s %.15g: %s\n", g->key[k].name, s->value[k],
                    g->key[k].help);
}

/* Writes the scene. Returns the exit status, which is OPTIONS_FAILURE if
   the values contradict each other. */
static int write_scene(const struct settings *s)
{
    struct scene scene;
    const char *wrong = s->scene->build(&scene, s->value);
    if (wrong) {
        program_say("%s: %s", s->scene->name, wrong);
        return OPTIONS_FAILURE;
    }
    struct table *out = table_open(PROGRAM, s->output);
    if (out) {
        write_head(s, out);
        scene_write(&scene, out);
    }
    scene_free(&scene);
    return out && table_close(out) ? EXIT_SUCCESS : EXIT_FAILURE;
}

/* Writes a scene. The first argument is the scene's name. Without a name,
   only --help, which lists all scenes, and --version are accepted. */
int main(int argc, char *argv[])
{
    struct settings s = {0};
    struct options o;
    struct options_entry entries[ENTRIES];
    char help[GALLERY_KEYS][160], purpose[200];
    if (argc > 1 && argv[1][0] != '-') {
        s.scene = find_scene(argv[1]);
        if (!s.scene)
            refuse_name(argv[1]);
        gallery_usual(s.scene, s.value);
        snprintf(purpose, sizeof purpose, "Write the scene %s: %s.",
                 s.scene->name, s.scene->about);
    }
    make_entries(s.scene, entries, help);
    options_begin(&o, PROGRAM, s.scene ? purpose : describe_all(), entries,
                  argc, argv);
    read_options(&s, &o);
    return write_scene(&s);
}
