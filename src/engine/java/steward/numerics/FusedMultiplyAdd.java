package steward.numerics;

import com.sun.management.HotSpotDiagnosticMXBean;
import java.lang.management.ManagementFactory;

/** Tests whether the processor has a fused multiply-add instruction. */
final class FusedMultiplyAdd {

    /**
     * True if {@code Math.fma} is compiled to one instruction: HotSpot's flag {@code UseFMA}, which the JVM sets from
     * the processor and the command line. False where the flag is unknown. Takes some milliseconds; call it once.
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
