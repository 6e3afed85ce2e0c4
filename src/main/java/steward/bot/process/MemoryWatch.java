package steward.bot.process;

import steward.bot.FaultMessages;
import steward.bot.accounting.TreeMemory;
import steward.bot.hold.WaitingSampler;

/**
 * Watch that ends a bot whose processes together exceed their memory limit, if no control group does so. It looks ten
 * times a second; for that long a bot may be above its limit.
 */
final class MemoryWatch implements WaitingSampler.WaitingBot {

    /** Of so many looks of the sampler one is taken. */
    private static final int EVERY = 5;

    private final ProcessGroup group;
    private final long limit;
    private final TreeMemory memory = new TreeMemory();
    private int looks;
    private volatile long found;

    /** @param limit in bytes */
    MemoryWatch(ProcessGroup group, long limit) {
        this.group = group;
        this.limit = limit;
        WaitingSampler.shared().add(this);
    }

    @Override
    public void look() {
        if (++looks % EVERY != 0 || found > 0) {
            return;
        }
        long bytes = memory.bytes(group.processes(), limit);
        if (bytes > limit) {
            found = bytes;
            group.kill();
        }
    }

    /** Fault of a bot that was ended; {@code null} if it was not. */
    String fault() {
        return found > 0 ? FaultMessages.memory(found, limit) : null;
    }

    /** It is looked at no more. */
    void end() {
        WaitingSampler.shared().remove(this);
    }
}
