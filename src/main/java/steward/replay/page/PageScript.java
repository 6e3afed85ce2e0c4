package steward.replay.page;

import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.files.Resources;

/**
 * Script of a page, combined from its JavaScript modules in the order of their imports. A browser that opens a file
 * from disk loads no modules, and one script has one hash. They are combined when a page is written, not when Steward
 * is built, since a jar with a game may bring a module that imports others.
 *
 * <p>Only two forms are read: a line that begins with {@code import ... from './name.js'} or
 * {@code import './name.js'}, and {@code export} before a declaration. Names at the top of
 * modules are unique among all of them.
 */
final class PageScript {

    private static final Pattern IMPORT = Pattern.compile(
        "^import (?:\\{[^}]*\\} from )?'(\\.{1,2}/[\\w./-]+\\.js)';\\n", Pattern.MULTILINE);
    private static final Pattern EXPORT = Pattern.compile("^export (?=(?:async |class|const|function|let))",
        Pattern.MULTILINE);
    private static final Pattern LEFT = Pattern.compile("^(?:import|export)\\b.*", Pattern.MULTILINE);
    private static final Pattern NAME = Pattern.compile("^(?:async )?(?:class|const|function|let) (\\w+)",
        Pattern.MULTILINE);

    private final StringBuilder script = new StringBuilder();
    private final Set<String> open = new LinkedHashSet<>();
    private final Set<String> added = new LinkedHashSet<>();
    private final Map<String, String> names = new HashMap<>();

    private PageScript() { }

    /**
     * Returns the script that ends with a module, after all that it imports.
     *
     * @param module resource of the last module
     * @param more   resource of a module to be added before it, or {@code null}
     * @throws IllegalStateException if a module is missing, imports itself in a circle, or repeats a name
     */
    static String of(String module, String more) {
        PageScript page = new PageScript();
        page.script.append("(() => {\n'use strict';\n");
        if (more != null) {
            page.add(more);
        }
        page.add(module);
        return page.script.append("})();\n").toString();
    }

    private void add(String module) {
        if (added.contains(module)) {
            return;
        }
        if (!open.add(module)) {
            throw new IllegalStateException("modules import each other in a circle: " + open);
        }
        String text = Resources.text(module);
        Matcher imports = IMPORT.matcher(text);
        while (imports.find()) {
            add(resolve(module, imports.group(1)));
        }
        String plain = EXPORT.matcher(IMPORT.matcher(text).replaceAll("")).replaceAll("");
        Matcher left = LEFT.matcher(plain);
        if (left.find()) {
            throw new IllegalStateException(module + ": found '" + left.group()
                + "', expected an import of one line or an export before a declaration");
        }
        Matcher declared = NAME.matcher(plain);
        while (declared.find()) {
            String other = names.put(declared.group(1), module);
            if (other != null) {
                throw new IllegalStateException(module + ": " + declared.group(1) + " is declared in " + other
                    + ", too");
            }
        }
        script.append(plain).append('\n');
        open.remove(module);
        added.add(module);
    }

    private static String resolve(String module, String path) {
        String folder = module.substring(0, module.lastIndexOf('/'));
        String rest = path.startsWith("./") ? path.substring(2) : path;
        while (rest.startsWith("../")) {
            folder = folder.substring(0, folder.lastIndexOf('/'));
            rest = rest.substring(3);
        }
        return folder + '/' + rest;
    }
}
