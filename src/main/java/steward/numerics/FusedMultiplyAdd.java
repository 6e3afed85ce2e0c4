package steward.numerics;

import com.sun.management.HotSpotDiagnosticMXBean;
import java.lang.management.ManagementFactory;

/** What the machine below does fast. */
final class FusedMultiplyAdd {

    private FusedMultiplyAdd() {
    }

    /**
     * Whether {@code Math.fma} is one instruction: what HotSpot's flag says after the JVM has looked at the processor
     * and the command line. False where nobody can say. It takes some milliseconds, so ask once.
     */
    static boolean hasFastFma() {
        try {
            HotSpotDiagnosticMXBean hotSpot = ManagementFactory.getPlatformMXBean(HotSpotDiagnosticMXBean.class);
            return hotSpot != null && Boolean.parseBoolean(hotSpot.getVMOption("UseFMA").getValue());
        } catch (IllegalArgumentException | LinkageError | SecurityException unknown) {
            return false;
        }
    }
}
