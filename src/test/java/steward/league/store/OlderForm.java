package steward.league.store;

import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.Map;

/** A database as Steward 0.2.0 had it, with the rows of today. */
public final class OlderForm {

    private OlderForm() { }

    /** Takes away what form 5 has added. */
    public static void of(Path database) throws SQLException {
        try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + database);
             Statement statement = connection.createStatement()) {
            statement.execute("PRAGMA foreign_keys = OFF");
            statement.execute("PRAGMA writable_schema = ON");
            for (Map.Entry<String, String> table : SchemaVersion.TABLES.entrySet()) {
                statement.execute("UPDATE sqlite_schema SET sql = '" + table.getValue().replaceAll(" -- .*", "")
                    .replaceAll(" CHECK \\(.+\\)", "").replaceAll(",\n +FOREIGN KEY .*", "")
                    .replaceAll(",? STRICT", "") + "' WHERE type = 'table' AND name = '" + table.getKey() + "'");
            }
            statement.execute("PRAGMA writable_schema = RESET");
            for (String table : new String[] {"season", "version", "machine", "lineup", "game"}) {
                statement.execute("ALTER TABLE " + table + " DROP COLUMN digest");
            }
            statement.execute("ALTER TABLE version DROP COLUMN paused");
            statement.execute("ALTER TABLE version DROP COLUMN time_limit");
            statement.execute("DROP TABLE decision");
            statement.execute("DROP INDEX game_all_failed");
            statement.execute("CREATE INDEX game_by_result ON game (season, counts, lineup, ranks)");
            statement.execute("PRAGMA user_version = 4");
        }
    }
}
