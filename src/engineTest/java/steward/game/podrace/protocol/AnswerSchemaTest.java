package steward.game.podrace.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.networknt.schema.InputFormat;
import com.networknt.schema.Schema;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.schema.Schemas;

/** The reader of answers and the schema that describes them come to the same verdicts. */
@Execution(ExecutionMode.CONCURRENT)
class AnswerSchemaTest {

    private static final Schema SCHEMA = Schemas.open("pod-race", "answer");

    /** Holds an answer with single quotes, in which P is a pod, to what is said of it. */
    private static void assertVerdicts(boolean read, boolean valid, String text) {
        String answer = text.replace("P", "{'x':1,'y':2,'thrust':3}").replace('\'', '"');
        byte[] bytes = answer.getBytes(StandardCharsets.UTF_8);

        assertEquals(read, new PodRaceAnswer(1, 200).read(bytes, bytes.length) == null, "read");
        assertEquals(valid, SCHEMA.validate(answer, InputFormat.JSON).isEmpty(), "valid");
    }

    @ParameterizedTest
    @ValueSource(strings = {
        "'x':1,'y':2,'thrust':0", "'x':1,'y':2,'thrust':200", "'x':1,'y':2,'shield':true", "'x':1,'y':2,'boost':true",
        "'thrust':7,'y':2,'x':1", "'x':-1.5,'y':2.25e3,'thrust':1", "'x':1e308,'y':-1e308,'thrust':1",
        "'x':0.000000000000000000000000001,'y':-0.0,'thrust':1", "'x':12345678901234567890,'y':0,'thrust':1"})
    void goodCommands(String fields) {
        assertVerdicts(true, true, "{'pods':[{" + fields + "}]}");
    }

    @ParameterizedTest
    @ValueSource(strings = {
        "", "'x':1,'y':2", "'x':1,'thrust':1", "'y':1,'thrust':1", "'x':'1','y':2,'thrust':1",
        "'x':null,'y':2,'thrust':1",
        "'x':true,'y':2,'thrust':1", "'x':[1],'y':2,'thrust':1", "'x':1,'y':2,'thrust':651", "'x':1,'y':2,'thrust':-1",
        "'x':1,'y':2,'thrust':1.5", "'x':1,'y':2,'thrust':'100'", "'x':1,'y':2,'thrust':null",
        "'x':1,'y':2,'thrust':99999999999999999999", "'x':1,'y':2,'shield':false", "'x':1,'y':2,'shield':1",
        "'x':1,'y':2,'shield':'true'", "'x':1,'y':2,'boost':false", "'x':1,'y':2,'boost':null",
        "'x':1,'y':2,'thrust':1,'shield':true", "'x':1,'y':2,'thrust':1,'boost':true",
        "'x':1,'y':2,'boost':true,'shield':true",
        "'x':1,'y':2,'boost':true,'shield':true,'thrust':1", "'x':1,'y':2,'thrust':1,'shield':false",
        "'x':1,'y':2,'thrust':1,'z':3", "'x':1,'y':2,'Thrust':1", "'x':1,'y':2,'thrust':1,'message':'m'",
        "'x':1e999,'y':2,'thrust':1", "'x':1,'y':-1e999,'thrust':1"})
    void badCommands(String fields) {
        assertVerdicts(false, false, "{'pods':[{" + fields + "}]}");
    }

    @ParameterizedTest
    @ValueSource(strings = {
        "{'pods':[P],'message':'m'}", "{'message':'','pods':[P]}", "  { 'pods' : [ P ] }  ",
        "{'pods':[P],'message':'\\u00e4\\ud83d\\ude00'}",
        "{'pods':[{'x':1,'y':2,'thrust':100.0}]}", "{'pods':[{'x':1,'y':2,'thrust':1e2}]}"})
    void goodAnswers(String text) {
        assertVerdicts(true, true, text);
    }

    @ParameterizedTest
    @ValueSource(strings = {
        "{}", "[]", "null", "1", "'pods'", "{'pods':null}", "{'pods':{}}", "{'pods':P}", "{'pods':[]}", "{'pods':[1]}",
        "{'pods':[null]}", "{'pods':[[P]]}", "{'pods':[P],'message':null}", "{'pods':[P],'message':1}",
        "{'pods':[P],'message':['m']}", "{'pods':[P],'massage':'m'}", "{'pod':[P]}", "{'message':'m'}"})
    void badAnswers(String text) {
        assertVerdicts(false, false, text);
    }

    /** A number of pods that another scene has, and what no JSON value can show. */
    @ParameterizedTest
    @ValueSource(strings = {
        "{'pods':[P,P]}",
        "{'pods':[P],'pods':[P]}", "{'pods':[{'x':1,'x':1,'y':2,'thrust':100}]}"})
    void beyondWhatASchemaCanSay(String text) {
        assertVerdicts(false, true, text);
    }
}
