# Lists of independent jobs, one command a line, for batch systems that run such lists
# on several machines (see README).

# `make jobs OF=grade' (or figures, atlas, hunt) writes the list build/jobs/grade. It
# takes the same variables as `make grade'. Jobs may run in any order, run twice, or be
# killed, for the files that they make are always whole or absent. Jobs whose files
# exist are not listed.
.PHONY: jobs
# $(call list,COMMAND) is the recipe of the goal jobs-NAME; COMMAND prints the list.
list = @$(unless_dry)mkdir -p build/jobs && { $(1); } >build/jobs/$(@:jobs-%=%).new && \
	mv build/jobs/$(@:jobs-%=%).new build/jobs/$(@:jobs-%=%) && echo \
	"Jobs: $$(wc -l <build/jobs/$(@:jobs-%=%)) in build/jobs/$(@:jobs-%=%)"
OF =
ifneq ($(filter jobs,$(MAKECMDGOALS)),)
ifeq ($(and $(filter 1,$(words $(value OF))),$(filter grade figures atlas hunt,$(value OF))),)
$(error jobs: OF: '$(value OF)' is not grade, figures, atlas or hunt)
endif
jobs: jobs-$(OF)
endif
