package arcomat.brick.need;

import arcomat.brick.api.BrickTable;
import arcomat.brick.api.BrickType;

import org.objectweb.asm.Type;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;

/**
 * The classes of the linked program. Which of leJOS' classes another one needs is written in bodies
 * that the table does not have: {@link LibraryCost} has it for what robots use. For all else, what
 * its head and its members name stands for that, and the number is an estimate.
 */
final class LinkedClasses {
    /** Classes of the empty program, as the linker counts them, its main class left out. */
    static final int EMPTY_PROGRAM = 75;

    /** What every program needs, besides the exceptions that the machine itself throws. */
    private static final List<String> ALWAYS =
            List.of("java/lang/Object", "java/lang/String", "java/lang/System", "java/lang/Thread");

    private final BrickTable table;
    private final LibraryCost library;
    private final Set<String> names = new TreeSet<>();
    private final Deque<String> open = new ArrayDeque<>();
    private boolean isExact = true;

    private LinkedClasses(BrickTable table, LibraryCost library) {
        this.table = table;
        this.library = library;
    }

    static LinkedClasses of(Code code, LibraryCost library, BrickTable table) {
        LinkedClasses linked = new LinkedClasses(table, library);
        Set<String> empty = linked.emptyProgram();
        for (String name : Linked.from(starts(code), code)) {
            if (!empty.contains(name)) {
                linked.add(name, code, empty);
            } else if (!library.emptyProgram().contains(name)) {
                // Likely to be in the empty program, by what heads of its classes name.
                linked.isExact = false;
            }
        }
        while (!linked.open.isEmpty()) {
            linked.follow(linked.open.pop(), empty);
        }
        return linked;
    }

    /** Where nobody calls a main method, all methods might be. */
    private static Set<MethodName> starts(Code code) {
        Set<MethodName> mains =
                code.methods().stream()
                        .filter(method -> method.name().equals("main"))
                        .collect(Collectors.toSet());
        return mains.isEmpty() ? code.methods() : mains;
    }

    private void add(String name, Code code, Set<String> empty) {
        if (code.type(name).isPresent() || isArray(name)) {
            names.add(name);
        } else {
            reach(name, empty);
        }
    }

    private void reach(String name, Set<String> empty) {
        if (!empty.contains(name)
                && (isArray(name) || table.contains(name) || library.knows(name))
                && names.add(name)) {
            open.push(name);
        }
    }

    private static boolean isArray(String name) {
        return name.startsWith("[");
    }

    private void follow(String name, Set<String> empty) {
        if (library.knows(name)) {
            library.brings(name).forEach(each -> bring(each, empty));
        } else if (!isArray(name)) {
            isExact = false;
            table.type(name).ifPresent(type -> named(type).forEach(each -> reach(each, empty)));
        }
    }

    /** What the library says needs no further look, unless it has a line of its own. */
    private void bring(String name, Set<String> empty) {
        if (library.knows(name)) {
            reach(name, empty);
        } else {
            names.add(name);
        }
    }

    /** What the head and the members of a class name. */
    private Set<String> named(BrickType type) {
        Set<String> all = new HashSet<>(type.interfaces());
        type.superclass().ifPresent(all::add);
        type.fields().forEach(field -> addNames(Type.getType(field.descriptor()), all));
        type.methods()
                .forEach(
                        method -> {
                            addNames(Type.getType(method.descriptor()), all);
                            all.addAll(method.exceptions());
                        });
        if (!type.name().startsWith("java/")) {
            // Drivers are made of their nested classes; the collections of java.util are not.
            table.nestedIn(type.name()).forEach(inner -> all.add(inner.name()));
        }
        return all;
    }

    private static void addNames(Type type, Set<String> names) {
        if (type.getSort() == Type.METHOD) {
            addNames(type.getReturnType(), names);
            for (Type argument : type.getArgumentTypes()) {
                addNames(argument, names);
            }
        } else if (type.getSort() == Type.OBJECT) {
            names.add(type.getInternalName());
        } else if (type.getSort() == Type.ARRAY && type.getElementType().getSort() == Type.OBJECT) {
            // Arrays of numbers are in the empty program.
            names.add(type.getDescriptor());
            addNames(type.getElementType(), names);
        }
    }

    private Set<String> emptyProgram() {
        Set<String> reached = new HashSet<>();
        Deque<String> waiting = new ArrayDeque<>(ALWAYS);
        table.types().stream()
                .filter(type -> type.packageName().equals("java/lang"))
                .filter(this::isThrowable)
                .forEach(type -> waiting.add(type.name()));
        while (!waiting.isEmpty()) {
            String name = waiting.pop();
            // What has a line of its own is known not to be among it.
            if (!library.knows(name) && reached.add(name)) {
                table.type(name).ifPresent(type -> waiting.addAll(named(type)));
            }
        }
        reached.addAll(library.emptyProgram());
        return reached;
    }

    private boolean isThrowable(BrickType type) {
        return type.name().equals("java/lang/Throwable")
                || type.superclass().flatMap(table::type).filter(this::isThrowable).isPresent();
    }

    int number() {
        return EMPTY_PROGRAM + names.size();
    }

    /** Whether none of them is estimated. */
    boolean isExact() {
        return isExact;
    }

    /** Those beyond the empty program: internal names, of arrays descriptors. */
    Set<String> names() {
        return names;
    }
}
