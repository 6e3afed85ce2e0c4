package steward.bot.process;

import steward.bot.Burner;
import steward.bot.accounting.TreeSampler;
import steward.bot.hold.HoldPolicy;
import steward.bot.hold.WaitingMeter;
import steward.bot.hold.WaitingSampler;

/**
 * Hold on one bot (its processes are stopped) while others are asked: always, or once the sampler finds that it uses
 * the processor. In a turn of a bot that is not held, this writes only two fields.
 *
 * <p>The sampler never stops a bot that is asked: the asking thread first stores {@link #waitingSince}, then reads
 * {@link #held}; the sampler first stores {@link #held} and then, under the lock of the group, reads the other.
 */
final class BotHold implements WaitingSampler.WaitingBot {

    /** A bot that has waited for less is not looked at, in nanoseconds: quick games cost nothing. */
    private static final long LEAST_WAIT = 5_000_000;

    /** After its start the compilers and collectors of a JVM are excused for so long, in nanoseconds. */
    private static final long YOUNG = 1_000_000_000;

    private static final long ASKED = 0;

    private final HoldPolicy policy;
    private final ProcessGroup group;
    private final TreeSampler tree;
    private final long started;
    private final WaitingMeter meter = new WaitingMeter();

    /** When the current wait began; {@link #ASKED} while there is none. No two waits begin at the same time. */
    private volatile long waitingSince = ASKED;
    private volatile boolean held;
    private long heldSince = Long.MAX_VALUE;
    private double processors;
    private boolean freed;
    private boolean young = true;

    /** @param tree of the bot's processes; not used by others */
    BotHold(HoldPolicy policy, ProcessGroup group, TreeSampler tree, long now) {
        this.policy = policy;
        this.group = group;
        this.tree = tree;
        started = now;
        if (policy == HoldPolicy.ALWAYS) {
            held = true;
            heldSince = now;
        }
        if (policy != HoldPolicy.NEVER) {                   // one that is held may let itself go on
            WaitingSampler.shared().add(this);
        }
    }

    /** Before the bot is asked: it goes on, and this returns when it does. */
    void asking() {
        waitingSince = ASKED;
        if (held) {
            group.pause(false);
        }
    }

    /** After its answer. */
    void answered(long now) {
        waitingSince = now;
        if (held) {
            group.pause(true);
            waitingSince = Watchdog.now();              // until then it was not stopped, which is not its doing
        }
    }

    /** True if it is held while others are asked. */
    boolean held() {
        return held;
    }

    @Override
    public void look() {
        long wait = waitingSince;
        long now = Watchdog.now();
        if (wait == ASKED || now - wait < LEAST_WAIT) {
            return;
        }
        synchronized (this) {
            if (young && now - started > YOUNG) {
                young = false;
                meter.reset();
            }
            meter.add(wait, young ? tree.withoutCompilers(now) : tree.baseline(now), young ? -1 : group.cpu());
            if (!meter.burns()) {
                return;
            }
            processors = meter.processors();
            if (held) {
                freed = true;                       // a timer of its own has let it go on
            } else if (group.canPause()) {
                heldSince = now;
                held = true;
                meter.reset();
            }
        }
        if (held) {
            group.pauseIf(() -> waitingSince != ASKED);
        }
    }

    /**
     * Processor time of the bot while others were asked.
     *
     * @param since when the question began in which another was late
     * @return {@code null} if it did not burn, or was held by then
     */
    synchronized Burner burner(long since) {
        if (policy == HoldPolicy.NEVER || heldSince <= since && !freed) {
            return null;
        }
        return held || meter.isSuspect() ? new Burner(-1, held ? processors : meter.processors(),
            group.canPause() && !freed) : null;
    }

    /** The bot is looked at no more. */
    void end() {
        WaitingSampler.shared().remove(this);
    }
}
