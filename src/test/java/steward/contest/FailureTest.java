package steward.contest;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FailureTest {

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "exited with status 3 before answering | exited with status 3 before answering",
        "killed by signal 11 (SIGSEGV) before answering | killed by signal 11 (SIGSEGV) before answering",
        "no answer within 75 ms (waited 76 ms) | no answer within 75 ms",
        "no answer within 75 ms (waited 1.2 ms): 1 of 2 lines came | no answer within 75 ms: 1 of 2 lines came",
        "no answer within 75 ms (waited 76 ms): computed 2, waited 53 for a processor, 2 other, 19 before the first "
            + "look | no answer within 75 ms",
        "no answer within 75 ms (waited 76 ms): 1 of 2 lines came; computed 2, waited 53 for a processor, 21 other"
            + " | no answer within 75 ms: 1 of 2 lines came",
        "no answer within 75 ms (waited 76 ms): the machine was busy: not its fault [computed 2, waited 53 for a "
            + "processor] | no answer within 75 ms",
        "no answer within 75 ms (waited 76 ms): computed all the time: an endless loop, or too slow? [computed 76]"
            + " | no answer within 75 ms",
        "no answer within 75 ms (waited 76 ms): this system does not show what the bot did meanwhile"
            + " | no answer within 75 ms",
        "no answer within 75 ms of CPU time (used 81 ms in 133 ms): computed 81, waited 40 for a processor, 12 other"
            + " | no answer within 75 ms of CPU time",
        "pods[0].thrust: found 201, expected a whole number 0..200; received: {\"pods\":[1]}"
            + " | pods[#].thrust: found #, expected a whole number #..#",
        "not JSON at column 7: found -1.5E-3; received: 1 2 | not JSON at column #: found #"})
    void theKindIsTheReasonWithoutWhatDiffersEachTime(String reason, String kind) {
        assertEquals(kind, new Failure(0, 1, reason, List.of(), List.of()).kind());
    }
}
