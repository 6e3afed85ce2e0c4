package steward.architecture;

import static com.tngtech.archunit.base.DescribedPredicate.describe;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import steward.cli.Main;
import steward.cli.shared.Lab;
import steward.game.Game;
import steward.match.TestScenes;

/** The classes of the three parts, wherever they were compiled to. */
final class HouseClasses {

    private HouseClasses() {
    }

    /** A class of each part, lowest first, by the name of the part's source set. */
    static Map<String, Class<?>> parts() {
        Map<String, Class<?>> parts = new LinkedHashMap<>();
        parts.put("engine", Game.class);
        parts.put("main", Main.class);
        parts.put("lab", Lab.find().orElseThrow().getClass());
        return parts;
    }

    /** The source folders of the three parts. */
    static List<Path> sources() {
        return parts().keySet().stream().map(part -> Path.of("src", part, "java")).toList();
    }

    /** All classes of the three parts, read once. */
    static JavaClasses all() {
        return Imported.ALL;
    }

    private static final class Imported {
        private static final JavaClasses ALL = new ClassFileImporter().importPaths(parts().values().stream()
            .map(HouseClasses::home).map(Path::of).toList());
    }

    /** Tests whether a class is of the part of another. */
    static DescribedPredicate<JavaClass> in(Class<?> type) {
        Path home = Path.of(home(type));
        return describe("is of the part of " + type,
            each -> Path.of(each.getSource().orElseThrow().getUri()).startsWith(home));
    }

    /** Where the classes of the tests are, of all parts. */
    static List<URI> homesOfTests() {
        try {
            return List.of(home(TestScenes.class), home(HouseClasses.class),
                home(Class.forName("steward.lab.cli.LabCommandsTest")));
        } catch (ClassNotFoundException missing) {
            throw new IllegalStateException(missing);
        }
    }

    static URI home(Class<?> type) {
        try {
            return type.getProtectionDomain().getCodeSource().getLocation().toURI();
        } catch (URISyntaxException problem) {
            throw new IllegalStateException(problem);
        }
    }
}
