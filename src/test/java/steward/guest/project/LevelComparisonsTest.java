package steward.guest.project;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Comparisons with the league level in class files: statements, and the numbers that follow from them by hand. */
@Tag("slow")
class LevelComparisonsTest {

    /** Each row: a statement, the highest level that it singles out, and the lowest above which all are alike. */
    private static final String STATEMENTS = """
        if (m.getLeagueLevel() >= 4) a();                                          | 4 | 4
        if (m.getLeagueLevel() > 4) a();                                           | 5 | 5
        if (m.getLeagueLevel() <= 4) a();                                          | 5 | 5
        if (4 < m.getLeagueLevel()) a();                                           | 5 | 5
        if (4 <= m.getLeagueLevel()) a();                                          | 4 | 4
        if (m.getLeagueLevel() == 3) a();                                          | 3 | 4
        switch (m.getLeagueLevel()) { case 1: a(); break; case 2: a(); break; default: } | 2 | 3
        switch (m.getLeagueLevel()) { case 1: a(); break; case 900: a(); break; default: } | 900 | 901
        int level = m.getLeagueLevel(); if (level < 6) a();                        | 6 | 6
        kept = m.getLeagueLevel(); score++; if (kept == 7) a();                    | 7 | 8
        own = m.getLeagueLevel(); if (this.own >= 8) a();                          | 8 | 8
        handed(1L, m.getLeagueLevel(), "x");                                       | 9 | 9
        Integer boxed = m.getLeagueLevel(); if (boxed > 9) a();                    | 10 | 10
        if (Integer.getInteger("league.level") >= 12) a();                         | 12 | 12
        if (Integer.parseInt(System.getProperty("league.level")) >= 13) a();       | 13 | 13
        if (result() > 2) a();                                                     | 3 | 3
        if (score > 1 ? m.getLeagueLevel() > 3 : score > 70) a();                  | 4 | 4
        if (score > 50) a();                                                       | 0 | 1
        int other = m.getLeagueLevel(); other = score; if (other > 50) a();        | 0 | 1
        if (m.getLeagueLevel() * 2 > 50) a();                                      | 0 | 1
        """;
    private static final String CLASS = """
        class C%d {
            static int kept;
            int own;
            int score;
            M m = new M();
            interface Level { int getLeagueLevel(); }
            static class M implements Level { public int getLeagueLevel() { return kept; } }
            void a() { }
            void run() { %s }
            int result() { return m.getLeagueLevel(); }
            void handed(long one, int level, String more) { %s }
        }
        """;

    @Test
    void levelsThatComparisonsSingleOutAreFound(@TempDir Path folder) throws IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        assumeTrue(compiler != null, "skipped: this is no JDK");
        List<String> rows = STATEMENTS.lines().toList();
        for (int row = 0; row < rows.size(); row++) {
            String statement = rows.get(row).split(" \\| ")[0];
            List<String> words = new ArrayList<>(List.of("-d", folder.resolve("c" + row).toString()));
            words.add(Files.writeString(folder.resolve("C" + row + ".java"), CLASS.formatted(row, statement,
                statement.startsWith("handed") ? "if (level >= 9) a();" : "")).toString());
            assertEquals(0, compiler.run(null, null, null, words.toArray(new String[0])), statement);
            LevelComparisons found = LevelComparisons.of(folder.resolve("c" + row));
            assertEquals(rows.get(row).replaceFirst(".*? \\| ", ""), found.singledOut() + " | " + found.lastChange(),
                statement);
        }
    }
}
