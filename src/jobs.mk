# Work for more machines than one: lists of independent jobs, one command a
# line, for engines that run such lists (see README).

# make jobs OF=grade|figures|atlas|hunt, with what the goal itself is given.
# A job may be run in any order, twice, and be killed: what it makes is there
# whole or not at all, and what is there is not listed.
.PHONY: jobs
# $(call list,COMMAND): the rule of a goal jobs-NAME.
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
