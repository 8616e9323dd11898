/* The scene player as the page's script calls it, here compiled for this
   machine: so the sanitizers see it too. */
#include "page/player.c"
#include "page/table.c"
#define UNIT_OWN_MAIN
#include "unit.h"

static void give(const char *text)
{
    char *room = page_text((double)strlen(text));
    UNIT_TRUE(room != NULL);
    if (room)
        strcpy(room, text);
}

TEST(test_nothing_yet, "nothing is asked for yet")
{
    UNIT_TRUE(page_word(KEYS * 1000) == NULL);
    UNIT_TRUE(page_word(HELP * 1000) == NULL);
    UNIT_TRUE(page_word(WRITTEN * 1000) == NULL);
    UNIT_TRUE(!page_begin() && strcmp(message, "no text") == 0);
    UNIT_TRUE(!page_observe() && !page_save(false, 1));
    UNIT_TRUE(!page_change(DT, 0.1));
    UNIT_EQUAL(page_run(1, 10), 0);
    UNIT_EQUAL(page_look()[4], -1);
    for (int which = PLACES; which <= OBSERVED; ++which)
        page_array(which);
}

/* Every scene of the gallery is made, begun, run, changed and saved, and
   the saved text is a scene again. */
TEST(test_every_scene, "every scene of the gallery")
{
    size_t scenes = 0;
    for (; page_word((double)(SCENES * 1000 + scenes)); ++scenes) {
        UNIT_TRUE(page_word((double)(ABOUT * 1000 + scenes)) != NULL);
        size_t keys = 0;
        for (; page_word((double)(KEYS * 1000 + keys)); ++keys) {
            double usual = 0;
            UNIT_TRUE(sscanf(message, "%*s %lf", &usual) == 1);
            UNIT_TRUE(page_word((double)(HELP * 1000 + keys)) != NULL);
            page_number[keys] = usual;
        }
        UNIT_TRUE(page_make((double)scenes));
        give(page_word(WRITTEN * 1000));
        page_number[0] = 0;
        UNIT_TRUE(page_begin());
        UNIT_EQUAL(page_run(1e9, 3), 3);
        const double bodies = page_look()[2];
        UNIT_TRUE(bodies >= 1 && page_look()[1] == 3);
        for (int which = PLACES; which <= FREE; ++which)
            UNIT_TRUE(page_array(which) != NULL);
        UNIT_TRUE(page_array(SPRINGS) != NULL);
        give("energy");
        UNIT_TRUE(page_observe() && page_look()[24] >= 1);
        UNIT_TRUE(page_array(OBSERVED) != NULL);
        UNIT_TRUE(page_change(GRAVITY + 1, -1) && page_look()[9] == -1);
        UNIT_EQUAL(page_run(1e9, 2), 2);
        give("--scene x");
        UNIT_TRUE(page_save(true, 1) &&
                  strstr(page_word(WRITTEN * 1000), "# 2 "));
        UNIT_TRUE(page_save(false, 1));
        give(page_word(WRITTEN * 1000));
        UNIT_TRUE(page_begin() && page_look()[2] == bodies);
    }
    UNIT_TRUE(scenes > 10 && !page_make((double)scenes));
}

TEST(test_no_scene, "what is no scene")
{
    give("particle (0 0 0) 1\nnonsense 3\n");
    UNIT_TRUE(!page_begin() && page_look()[6] > 0);
    UNIT_TRUE(strlen(page_word(MESSAGE * 1000)) > 0);
    give("what");
    UNIT_TRUE(!page_observe());
}

/* Two small bodies that a long step moves through each other, by either law
   of contact, are counted and named; short steps see their collision. */
TEST(test_passed, "bodies that pass through each other")
{
    static const char *const contacts[] = {"contact",
                                           "contact\nlinear 1e3"};
    static const char *const steps[] = {"0.3", "0.003"};
    for (size_t k = 0; k < 4; ++k) {
        const bool missed = k / 2 == 0;
        char text[200];
        snprintf(text, sizeof text,
                 "pos 0 0 1 0 1 0 0.1\npos 1 -1 0 0 1 0 0.013\n"
                 "pos 2 1 0 0 1 0 0.013\nvel 1 1 0 0\nvel 2 -1 0 0\n"
                 "%s\ndt %s\n",
                 contacts[k % 2], steps[k / 2]);
        give(text);
        UNIT_TRUE(page_begin() && page_look()[26] == 0);
        page_run(3, 1e6);
        UNIT_EQUAL(page_look()[26], missed ? 1 : 0);
        UNIT_EQUAL(page_look()[27], missed ? 1 : 0);
        UNIT_EQUAL(page_look()[28], missed ? 2 : 0);
    }
}

int main(void)
{
    const int status = unit_run("player");
    stop();
    scene_free(&start);
    scene_free(&scene);
    free(given);
    free(written);
    return status;
}
