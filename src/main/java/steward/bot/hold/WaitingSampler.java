package steward.bot.hold;

import java.util.Arrays;
import java.util.concurrent.locks.LockSupport;

/**
 * The one thread of this JVM that measures waiting bots while others are asked. It sleeps if there are none; the
 * threads that play never wait for it.
 */
public final class WaitingSampler implements Runnable {

    /**
     * Between two rounds of looks, in nanoseconds: five of them see the {@link WaitingMeter#WINDOW}, and a look at a
     * small bot takes a tenth of a millisecond.
     */
    private static final long STEP = 20_000_000;

    private volatile WaitingBot[] bots = {};
    private volatile Thread thread;

    /** A bot as it is looked at. */
    public interface WaitingBot {

        /** Called after each {@link #STEP}, whether the bot is waiting or not. */
        void look();
    }

    private WaitingSampler() { }

    private static final class Shared {
        static final WaitingSampler INSTANCE = start();

        private static WaitingSampler start() {
            WaitingSampler sampler = new WaitingSampler();
            Thread thread = new Thread(sampler, "steward-sampler");
            thread.setDaemon(true);
            sampler.thread = thread;
            thread.start();
            return sampler;
        }
    }

    /** The sampler of this JVM; the first call starts its thread. */
    public static WaitingSampler shared() {
        return Shared.INSTANCE;
    }

    /** From now on the bot is looked at. */
    public synchronized void add(WaitingBot bot) {
        WaitingBot[] more = Arrays.copyOf(bots, bots.length + 1);
        more[bots.length] = bot;
        bots = more;
        if (more.length == 1) {
            LockSupport.unpark(thread);
        }
    }

    /** The bot is looked at no more, but for a look that is under way. */
    public synchronized void remove(WaitingBot bot) {
        bots = Arrays.stream(bots).filter(each -> each != bot).toArray(WaitingBot[]::new);
    }

    @Override
    public void run() {
        for (;;) {
            WaitingBot[] now = bots;
            if (now.length == 0) {
                LockSupport.park(this);
            } else {
                LockSupport.parkNanos(this, STEP);
            }
            for (WaitingBot bot : now) {
                bot.look();
            }
        }
    }
}
