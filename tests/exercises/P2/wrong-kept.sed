# mistake: looks-of-the-kept, stage 5
/static void throw_disks/,/^}/s/    print_histogram/    looks = samples * n * (n - 1) \/ 2;\n    print_histogram/
