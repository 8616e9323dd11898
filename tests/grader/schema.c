/* Checks JSON files against a schema, in the part of JSON Schema that the
   schemas beside this file use. A keyword that it does not know is an error
   of its own: what is not understood must not be taken for fulfilled.

       schema SCHEMA FILE...         says what is wrong, a line each; exits
                                     with 0 if nothing is, 1 if something is
       schema --values KEY FILE...   the values that the files have under
                                     this key, in order, a line each

   Exits with 2 for what it cannot read or does not know. */
#include <jansson.h>
#include <regex.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct place {
    const struct place *above;
    const char *key; /* or NULL: a number */
    size_t number;
};

static const char *file;
static int wrong;

static _Noreturn void fail(const char *what, const char *which)
{
    fprintf(stderr, "schema: %s '%s'\n", what, which);
    exit(2);
}

static void print_place(const struct place *p)
{
    if (!p)
        return;
    print_place(p->above);
    if (p->key)
        printf("/%s", p->key);
    else
        printf("/%zu", p->number);
}

static void complain(const struct place *p, const char *format, ...)
{
    va_list arguments;
    printf("schema: %s: ", file);
    print_place(p);
    printf(": ");
    va_start(arguments, format);
    vprintf(format, arguments);
    va_end(arguments);
    putchar('\n');
    ++wrong;
}

static bool is_type(const json_t *json, const char *type)
{
    static const struct {
        const char *name;
        json_type first, second;
    } types[] = {
        {"object", JSON_OBJECT, JSON_OBJECT},
        {"array", JSON_ARRAY, JSON_ARRAY},
        {"string", JSON_STRING, JSON_STRING},
        {"integer", JSON_INTEGER, JSON_INTEGER},
        {"number", JSON_INTEGER, JSON_REAL},
        {"boolean", JSON_TRUE, JSON_FALSE},
    };
    for (size_t i = 0; i < sizeof types / sizeof types[0]; ++i)
        if (strcmp(types[i].name, type) == 0)
            return json_typeof(json) == types[i].first ||
                   json_typeof(json) == types[i].second;
    fail("unknown type", type);
}

/* How many characters, as JSON Schema counts. */
static size_t characters(const char *text)
{
    size_t count = 0;
    for (; *text; ++text)
        count += (*text & 0xc0) != 0x80;
    return count;
}

static bool matches(const char *text, const char *pattern)
{
    regex_t compiled;
    if (regcomp(&compiled, pattern, REG_EXTENDED | REG_NOSUB) != 0)
        fail("cannot compile the pattern", pattern);
    const bool found = regexec(&compiled, text, 0, NULL, 0) == 0;
    regfree(&compiled);
    return found;
}

static void validate(const json_t *json, const json_t *schema,
                     const struct place *p);

static void check_required(const json_t *json, const json_t *keys,
                           const struct place *p)
{
    size_t i;
    json_t *key;
    json_array_foreach(keys, i, key)
    {
        if (!json_object_get(json, json_string_value(key)))
            complain(p, "'%s' is missing", json_string_value(key));
    }
}

static void check_properties(const json_t *json, const json_t *schema,
                             const struct place *p)
{
    const json_t *known = json_object_get(schema, "properties");
    const json_t *more = json_object_get(schema, "additionalProperties");
    const char *key;
    json_t *value;
    json_object_foreach((json_t *)json, key, value)
    {
        const struct place below = {p, key, 0};
        const json_t *its = json_object_get(known, key);
        if (its)
            validate(value, its, &below);
        else if (json_is_false(more))
            complain(&below, "no such field");
    }
}

static void check_one_of(const json_t *json, const json_t *values,
                         const struct place *p)
{
    for (size_t i = 0; i < json_array_size(values); ++i)
        if (json_equal(json, json_array_get(values, i)))
            return;
    complain(p, "none of the values that there are");
}

static void check_items(const json_t *json, const json_t *schema,
                        const struct place *p)
{
    for (size_t i = 0; i < json_array_size(json); ++i) {
        const struct place below = {p, NULL, i};
        validate(json_array_get(json, i), schema, &below);
    }
}

static void check_text(const char *text, const char *keyword,
                       const json_t *limit, const struct place *p)
{
    const size_t bound = (size_t)json_integer_value(limit);
    if (strcmp(keyword, "pattern") == 0) {
        if (!matches(text, json_string_value(limit)))
            complain(p, "does not match %s", json_string_value(limit));
    } else if (strcmp(keyword, "minLength") == 0) {
        if (characters(text) < bound)
            complain(p, "fewer than %zu characters", bound);
    } else if (characters(text) > bound) {
        complain(p, "more than %zu characters", bound);
    }
}

static const char *const notes[] = {"$schema", "title", "description",
                                    NULL};
static const char *const texts[] = {"pattern", "minLength", "maxLength",
                                    NULL};
static const char *const others[] = {"type",     "const",      "enum",
                                     "required", "properties", "items",
                                     "minimum",  NULL};

static bool among(const char *word, const char *const list[])
{
    while (*list && strcmp(*list, word) != 0)
        ++list;
    return *list != NULL;
}

static void check_keyword(const json_t *json, const json_t *schema,
                          const char *keyword, const json_t *value,
                          const struct place *p)
{
    if (strcmp(keyword, "type") == 0) {
        if (!is_type(json, json_string_value(value)))
            complain(p, "not of type %s", json_string_value(value));
    } else if (strcmp(keyword, "const") == 0) {
        if (!json_equal(json, value))
            complain(p, "not the one value that there is");
    } else if (strcmp(keyword, "enum") == 0) {
        check_one_of(json, value, p);
    } else if (strcmp(keyword, "required") == 0) {
        if (json_is_object(json))
            check_required(json, value, p);
    } else if (strcmp(keyword, "properties") == 0) {
        check_properties(json, schema, p);
    } else if (strcmp(keyword, "items") == 0) {
        check_items(json, value, p);
    } else if (strcmp(keyword, "minimum") == 0) {
        if (json_is_number(json) &&
            json_number_value(json) < json_number_value(value))
            complain(p, "less than %g", json_number_value(value));
    } else if (among(keyword, texts) && json_is_string(json)) {
        check_text(json_string_value(json), keyword, value, p);
    }
}

static void validate(const json_t *json, const json_t *schema,
                     const struct place *p)
{
    const char *keyword;
    json_t *value;
    json_object_foreach((json_t *)schema, keyword, value)
    {
        check_keyword(json, schema, keyword, value, p);
    }
}

/* Ends the program at a keyword that check_keyword does not know, or not in
   this form. */
static void look_through(const json_t *schema)
{
    const char *keyword;
    json_t *value, *properties = json_object_get(schema, "properties");
    json_object_foreach((json_t *)schema, keyword, value)
    {
        if (strcmp(keyword, "additionalProperties") == 0) {
            if (!json_is_boolean(value) || !properties)
                fail("a form that is not known of", keyword);
        } else if (!among(keyword, notes) && !among(keyword, texts) &&
                   !among(keyword, others)) {
            fail("unknown keyword", keyword);
        }
    }
    json_object_foreach(properties, keyword, value)
    {
        look_through(value);
    }
    if (json_object_get(schema, "items"))
        look_through(json_object_get(schema, "items"));
}

static json_t *load(const char *path)
{
    json_error_t error;
    json_t *json = json_load_file(
        path, JSON_REJECT_DUPLICATES | JSON_ALLOW_NUL, &error);
    if (!json) {
        fprintf(stderr, "schema: %s:%d: %s\n", path, error.line,
                error.text);
        exit(2);
    }
    return json;
}

static void print_values(json_t *json, const char *wanted)
{
    const char *key;
    json_t *value;
    for (size_t i = 0; i < json_array_size(json); ++i)
        print_values(json_array_get(json, i), wanted);
    json_object_foreach(json, key, value)
    {
        if (strcmp(key, wanted) != 0 || json_is_object(value) ||
            json_is_array(value)) {
            print_values(value, wanted);
        } else if (json_is_string(value)) {
            for (const char *c = json_string_value(value); *c; ++c)
                putchar(*c == '\n' ? ' ' : *c);
            putchar('\n');
        } else {
            json_dumpf(value, stdout, JSON_ENCODE_ANY);
            putchar('\n');
        }
    }
}

int main(int argc, char **argv)
{
    const bool values = argc > 3 && strcmp(argv[1], "--values") == 0;
    if (argc < 3)
        fail("usage: schema SCHEMA FILE...; there is no file after",
             argv[argc - 1]);
    json_t *schema = values ? NULL : load(argv[1]);
    look_through(schema);
    for (int i = values ? 3 : 2; i < argc; ++i) {
        json_t *json = load(argv[i]);
        file = argv[i];
        if (values)
            print_values(json, argv[2]);
        else
            validate(json, schema, NULL);
        json_decref(json);
    }
    json_decref(schema);
    return wrong > 0;
}
