package steward.guest.project;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import steward.files.InputException;
import steward.guest.project.ClassFile.Member;
import steward.guest.project.ClassFile.Method;

/**
 * Numbers with which a contest's class files compare the league level. The level is followed from the calls that return
 * it through variables, fields, parameters and results. If its way is not plain, it is lost, so that a comparison may
 * be missed, but hardly one is invented.
 *
 * <p>An order such as {@code level > 4} or {@code level >= 5} changes at 5 and singles 5 out. An equality with 4, or a
 * case of a switch, singles 4 out and changes at 4 and 5.
 */
final class LevelComparisons {

    private static final String CALL = "getLeagueLevel";
    private static final String PROPERTY = "league.level";
    /** Passes over all classes: a level is handed on at most so often before it is compared. */
    private static final int MOST_PASSES = 8;
    /** Things on the stack of the JVM. A number is itself. */
    private static final Object LEVEL = "level";
    private static final Object OTHER = "other";

    private final List<ClassFile> files;
    /** Fields, results and parameters that are the level. A parameter is a list of its method and its variable. */
    private final Set<Object> known = new HashSet<>();
    private final Deque<Object> stack = new ArrayDeque<>();
    /** Variables of the method that is followed that are the level. */
    private final Set<Integer> variables = new HashSet<>();
    private int singledOut;
    private int lastChange = 1;

    private LevelComparisons(List<ClassFile> files) {
        this.files = files;
        int before = -1;
        for (int pass = 0; pass < MOST_PASSES && before != known.size(); pass++) {
            before = known.size();
            files.forEach(file -> file.methods().forEach(method -> follow(file, method)));
        }
    }

    /** @param classes the folder or jar of a contest */
    static LevelComparisons of(Path classes) {
        try {
            if (Files.isDirectory(classes)) {
                return new LevelComparisons(read(classes));
            }
            try (FileSystem jar = FileSystems.newFileSystem(classes)) {
                return new LevelComparisons(read(jar.getPath("/com/codingame")));
            }
        } catch (IOException problem) {
            throw new InputException(classes + ": cannot be read: " + problem.getMessage());
        }
    }

    private static List<ClassFile> read(Path folder) throws IOException {
        List<ClassFile> files = new ArrayList<>();
        try (Stream<Path> all = Files.isDirectory(folder) ? Files.walk(folder) : Stream.empty()) {
            for (Path file : all.filter(each -> each.toString().endsWith(".class")
                    && !each.toString().contains("/gameengine/")).sorted().toList()) {
                try (InputStream in = Files.newInputStream(file)) {
                    files.add(ClassFile.read(in));
                }
            }
        }
        return files;
    }

    /** Highest level that a comparison singles out; 0 without comparisons. */
    int singledOut() {
        return singledOut;
    }

    /** Lowest level above which all levels compare alike; 1 without comparisons. */
    int lastChange() {
        return lastChange;
    }

    private void follow(ClassFile file, Method method) {
        stack.clear();
        variables.clear();
        int variable = method.isStatic() ? 0 : 1;
        for (char type : parameters(method.member().descriptor())) {
            if (known.contains(List.of(method.member(), variable))) {
                variables.add(variable);
            }
            variable += size(type);
        }
        ByteBuffer code = ByteBuffer.wrap(method.code());
        while (code.hasRemaining()) {
            step(file, method, code, code.get() & 0xFF);
        }
    }

    /** Follows one instruction (The Java Virtual Machine Specification, section 6.5). */
    private void step(ClassFile file, Method method, ByteBuffer code, int op) {
        if (op >= 2 && op <= 8) {                              // iconst
            stack.push(op - 3);
        } else if (op == 1 || op >= 9 && op <= 15) {           // other constants
            stack.push(OTHER);
        } else if (op == 16 || op == 17) {                     // bipush, sipush
            stack.push(op == 16 ? (int) code.get() : (int) code.getShort());
        } else if (op >= 18 && op <= 20) {                     // ldc
            Object constant = file.constants()[op == 18 ? code.get() & 0xFF : code.getShort() & 0xFFFF];
            stack.push(constant instanceof Integer ? constant : PROPERTY.equals(constant) ? LEVEL : OTHER);
        } else if (op >= 21 && op <= 45) {                     // loads
            stack.push(variables.contains(op <= 25 ? code.get() & 0xFF : (op - 26) % 4) ? LEVEL : OTHER);
        } else if (op >= 54 && op <= 78) {                     // stores
            store(op <= 58 ? code.get() & 0xFF : (op - 59) % 4, pop());
        } else if (op >= 178 && op <= 181) {                   // fields
            field(file.constants()[code.getShort() & 0xFFFF], op);
        } else if (op >= 182 && op <= 185) {                   // calls
            call((Member) file.constants()[code.getShort() & 0xFFFF], op == 184);
            code.position(code.position() + (op == 185 ? 2 : 0));
        } else if (op >= 153 && op <= 166 || op == 198 || op == 199) {     // comparisons
            code.getShort();
            Object second = pop();
            if (op >= 159 && op <= 164) {
                compare(op, pop(), second);
            } else if (op >= 165 && op <= 166) {
                pop();
            }
        } else if (op == 170 || op == 171) {
            select(code, op == 170, pop() == LEVEL);
        } else if (op == 172 || op == 176) {                   // ireturn, areturn
            if (pop() == LEVEL) {
                known.add(method.member());
            }
            stack.clear();
        } else {
            pass(code, op);
        }
    }

    /** Passes over an instruction that loses the level, or keeps it as it is. */
    private void pass(ByteBuffer code, int op) {
        switch (op) {
            case 0, 192 -> { }                                 // nop, checkcast
            case 87, 194, 195 -> pop();
            case 89 -> stack.push(stack.isEmpty() ? OTHER : stack.peek());
            case 187 -> stack.push(OTHER);                     // new
            case 132 -> variables.remove(code.get(code.position()) & 0xFF);
            case 116, 117, 118, 119, 188, 189, 190, 193 -> replace(1);
            case 196 -> {                                      // wide
                int widened = code.get() & 0xFF;
                code.getShort();
                if (widened == 132) {
                    code.getShort();
                }
                stack.clear();
            }
            default -> {
                if (op >= 96 && op <= 131 || op >= 148 && op <= 152 || op >= 46 && op <= 53) {
                    replace(2);                                // arithmetic, comparisons of others, loads of arrays
                } else if (op < 133 || op > 147) {             // not conversions
                    stack.clear();
                }
            }
        }
        int behind = op == 188 ? 1 : op == 132 || op == 167 || op == 187 || op == 189 || op == 192 || op == 193 ? 2
            : op == 197 ? 3 : op == 186 || op == 200 ? 4 : 0;
        code.position(code.position() + behind);
    }

    private Object pop() {
        return stack.isEmpty() ? OTHER : stack.pop();
    }

    private void replace(int count) {
        for (int k = 0; k < count; k++) {
            pop();
        }
        stack.push(OTHER);
    }

    private void store(int variable, Object value) {
        if (value == LEVEL) {
            variables.add(variable);
        } else {
            variables.remove(variable);
        }
    }

    /** Follows a field that is read or written. */
    private void field(Object member, int op) {
        boolean written = op == 179 || op == 181;
        if (written && pop() == LEVEL) {
            known.add(member);
        }
        if (op >= 180) {
            pop();
        }
        if (!written) {
            stack.push(known.contains(member) ? LEVEL : OTHER);
        }
    }

    /** Hands a level on to parameters, and takes it as a result. Methods of the JDK, as for boxing, return it. */
    private void call(Member member, boolean isStatic) {
        List<Character> types = parameters(member.descriptor());
        int variable = isStatic ? 0 : 1;
        for (char type : types) {
            variable += size(type);
        }
        boolean any = false;
        for (int k = types.size() - 1; k >= 0; k--) {
            variable -= size(types.get(k));
            if (pop() == LEVEL) {
                any = true;
                known.add(List.of(member, variable));
            }
        }
        any |= !isStatic && pop() == LEVEL;
        if (!member.descriptor().endsWith(")V")) {
            any &= member.owner().startsWith("java/lang/");
            stack.push(any || member.name().equals(CALL) || known.contains(member) ? LEVEL : OTHER);
        }
    }

    /** First letters of the types of a method's parameters. */
    private static List<Character> parameters(String descriptor) {
        List<Character> types = new ArrayList<>();
        for (int at = 1; descriptor.charAt(at) != ')'; at++) {
            types.add(descriptor.charAt(at));
            while (descriptor.charAt(at) == '[') {
                at++;
            }
            at = descriptor.charAt(at) == 'L' ? descriptor.indexOf(';', at) : at;
        }
        return types;
    }

    /** Variables that a parameter takes. */
    private static int size(char type) {
        return type == 'J' || type == 'D' ? 2 : 1;
    }

    /** Takes a comparison of integers: equal, not equal, less, not less, greater, not greater, from 159 on. */
    private void compare(int op, Object first, Object second) {
        boolean mirrored = second == LEVEL;
        if (first != LEVEL && !mirrored || !((mirrored ? first : second) instanceof Integer number)) {
            return;
        }
        if (op <= 160) {
            equal(number);
        } else {
            int change = number + (op <= 162 == mirrored ? 1 : 0);
            singledOut = Math.max(singledOut, change);
            lastChange = Math.max(lastChange, change);
        }
    }

    private void equal(int number) {
        singledOut = Math.max(singledOut, number);
        lastChange = Math.max(lastChange, number + 1);
    }

    /** Takes a switch by a table or by pairs; cases of a table that go where the others go are none. */
    private void select(ByteBuffer code, boolean table, boolean ofLevel) {
        code.position((code.position() + 3) / 4 * 4);
        int otherwise = code.getInt();
        int first = table ? code.getInt() : 0;
        int count = table ? code.getInt() - first + 1 : code.getInt();
        for (int k = 0; k < count; k++) {
            int number = table ? first + k : code.getInt();
            if (code.getInt() != otherwise && ofLevel) {
                equal(number);
            }
        }
        stack.clear();
    }
}
