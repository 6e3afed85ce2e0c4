package steward.game.podrace.simulator;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Flags under which {@code steward_podrace.hpp} computes as ever, and those that it refuses. */
@Tag("process")
@Execution(ExecutionMode.CONCURRENT)
class CppHeaderRefusalTest {

    private static final String PROGRAM = """
        #include "steward_podrace.hpp"
        #include <cstdio>
        int main() {
            try {
                steward::Map map({{12460, 1350}, {10540, 5980}, {3580, 5180}});
                std::puts("fine");
            } catch (const std::runtime_error& refused) {
                std::puts(refused.what());
            }
        }
        """;
    private static final String FINE = "fine";
    private static final String CONTRACTED = "steward_podrace.hpp: operations are contracted or reordered; compile "
        + "without -ffast-math and -Ofast";
    private static final String FLUSHED = "steward_podrace.hpp: numbers below 2^-1022 are flushed to zero; link "
        + "without -Ofast and -ffast-math";

    @TempDir
    private Path folder;

    @BeforeEach
    void header() throws IOException {
        Files.copy(CppHeader.HEADER, folder.resolve(CppHeader.HEADER.getFileName()));
        Files.writeString(folder.resolve("program.cpp"), PROGRAM);
    }

    private static void needs(String compiler) throws IOException {
        assumeTrue(CppHeader.isInstalled(compiler), "skipped: there is no " + compiler);
        assumeTrue(CppHeader.hasAvx2(), "skipped: the processor has no AVX2");
    }

    private record Said(int status, String text) {
    }

    private Said run(List<String> words) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(words).directory(folder.toFile()).redirectErrorStream(true).start();
        String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        return new Said(process.waitFor(), text.strip());
    }

    /** Output of the program that these words compile. */
    private String said(String... words) throws IOException, InterruptedException {
        List<String> call = new ArrayList<>(List.of(words));
        call.addAll(List.of("-std=c++17", "-o", "program"));
        Said compiled = run(call);
        assertEquals(0, compiled.status(), call + "\n" + compiled.text());
        return run(List.of("./program")).text();
    }

    @Test
    @Tag("campaign")
    void contractionIsSwitchedOff() throws IOException, InterruptedException {
        needs("g++");
        for (String flag : List.of("-O2", "-O3", "-frounding-math")) {
            assertEquals(FINE, said("g++", "program.cpp", "-O3", "-mavx2", "-mfma", "-ffp-contract=fast", flag));
        }
    }

    /** By this flag clang contracts whatever a file says. */
    @Test
    @Tag("campaign")
    void clangContractsNothingUnlessItIsToldTo() throws IOException, InterruptedException {
        needs("clang++");
        assertEquals(FINE, said("clang++", "program.cpp", "-O3", "-mavx2", "-mfma"));
        for (String level : List.of("-O2", "-O3")) {
            assertEquals(CONTRACTED, said("clang++", "program.cpp", level, "-mavx2", "-mfma", "-ffp-contract=fast"));
        }
    }

    /**
     * The link with one of these flags sets the processor to flush tiny numbers; the compiler alone does no harm: it
     * neither contracts nor reorders.
     */
    @Test
    @Tag("campaign")
    void ofastIsRefusedWhereItFlushesTinyNumbers() throws IOException, InterruptedException {
        needs("g++");
        assertEquals(0, run(List.of("g++", "-std=c++17", "-Ofast", "-mavx2", "-mfma", "-ffp-contract=fast", "-c",
            "program.cpp")).status());
        assertEquals(FLUSHED, said("g++", "program.o", "-Ofast"));
        assertEquals(FLUSHED, said("g++", "program.o", "-ffast-math"));
        assertEquals(FINE, said("g++", "program.o"));
    }

    @Test
    @Tag("campaign")
    void ofastIsRefusedWhereOneCallCompilesAndLinks() throws IOException, InterruptedException {
        needs("g++");
        assertEquals(FLUSHED, said("g++", "program.cpp", "-Ofast"));
        assertEquals(FLUSHED, said("g++", "program.cpp", "-O2", "-ffast-math"));
    }

    @Test
    void clangWithFastMathDoesNotCompile() throws IOException, InterruptedException {
        needs("clang++");
        Said refused = run(List.of("clang++", "-std=c++17", "-O2", "-ffast-math", "-c", "program.cpp"));
        assertNotEquals(0, refused.status());
        assertTrue(refused.text().contains("clang cannot be told to be exact within a file"), refused.text());
    }

    /** Without its pragma the header finds in its self-check that operations are contracted. */
    @Test
    @Tag("campaign")
    void whatRemainsIsFoundByTheSelfCheck() throws IOException, InterruptedException {
        needs("g++");
        leaveOutThePragma();
        assertEquals(CONTRACTED, said("g++", "program.cpp", "-O2", "-mavx2", "-mfma", "-ffp-contract=fast"));
    }

    @Test
    @Tag("campaign")
    void theSelfCheckFindsWhatIsReorderedAndNothingElse() throws IOException, InterruptedException {
        needs("g++");
        leaveOutThePragma();
        assertEquals(CONTRACTED, said("g++", "program.cpp", "-O3", "-mavx2", "-mfma", "-ffp-contract=fast"));
        assertEquals(FINE, said("g++", "program.cpp", "-O3", "-mavx2", "-mfma", "-ffp-contract=off"));
        assertEquals(0, run(List.of("g++", "-std=c++17", "-Ofast", "-mavx2", "-c", "program.cpp")).status());
        assertNotEquals(FINE, said("g++", "program.o"), "reordered");
    }

    private void leaveOutThePragma() throws IOException {
        Path header = folder.resolve(CppHeader.HEADER.getFileName());
        String whole = Files.readString(header);
        String without = whole.replaceFirst("#pragma GCC optimize\\(.*\\)\n", "");
        assertNotEquals(whole, without);
        Files.writeString(header, without);
    }
}
