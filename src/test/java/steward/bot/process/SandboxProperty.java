package steward.bot.process;

/** Runs a test as on a machine without a C compiler. */
final class SandboxProperty {

    private static final String PROPERTY = "steward.sandbox.native";

    private SandboxProperty() {
    }

    static void withoutProgram(Runnable test) {
        System.setProperty(PROPERTY, "false");
        try {
            test.run();
        } finally {
            System.clearProperty(PROPERTY);
        }
    }
}
