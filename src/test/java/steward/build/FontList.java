package steward.build;

import java.awt.Font;
import java.nio.file.Path;
import org.junit.platform.launcher.LauncherSession;
import org.junit.platform.launcher.LauncherSessionListener;

/**
 * Java's list of the machine's fonts, which the JDK on Linux writes into the folder {@code .java} of {@code user.home}
 * when a program first draws text. Tests of charts do; they have it below the folder of the build, so that tests write
 * nothing into the home of who runs them. JUnit finds this listener by {@link java.util.ServiceLoader}.
 */
public final class FontList implements LauncherSessionListener {

    @Override
    public void launcherSessionOpened(LauncherSession session) {
        String home = System.getProperty("user.home");
        System.setProperty("java.awt.headless", "true");
        System.setProperty("user.home", Path.of("build", "home").toAbsolutePath().toString());
        try {
            new Font(Font.DIALOG, Font.PLAIN, 1).canDisplay('a');
        } finally {
            System.setProperty("user.home", home);
        }
    }
}
