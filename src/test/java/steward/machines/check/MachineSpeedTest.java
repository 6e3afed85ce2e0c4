package steward.machines.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class MachineSpeedTest {

    @Test
    void limitsGrowAsAMachineIsSlower() {
        assertEquals(1, MachineSpeed.scale(1000, 1000));
        assertEquals(2.5, MachineSpeed.scale(1000, 400));
        assertEquals(0.33, MachineSpeed.scale(1000, 3000));
        assertEquals(8, MachineSpeed.scale(1000, 1), "a worker may say anything");
        assertEquals(0.12, MachineSpeed.scale(1, 1000));
        assertEquals(1, MachineSpeed.scale(1000, 0), "a worker that says nothing");
    }

    @Test
    void aMachineIsAsFastAsItself() {
        double ratio = (double) MachineSpeed.measure() / MachineSpeed.measure();
        assertTrue(ratio > 0.25 && ratio < 4, "found " + ratio);
    }
}
