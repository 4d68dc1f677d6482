package arcomat.brick.need;

import arcomat.brick.need.LinkedTypes.Method;
import arcomat.brick.need.flow.MethodName;

import org.jspecify.annotations.Nullable;
import org.objectweb.asm.Type;

import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;

/**
 * What the linker of leJOS NXJ 0.9.1 keeps of a program, found as it does: from the main method,
 * and from what the machine itself calls, it follows calls, and keeps classes whose objects,
 * arrays, statics or methods are used there. A method is followed wherever an object that may be
 * there could be asked for it. Classes of the machine are kept in any case, and so are exceptions
 * that some method would handle.
 */
final class Linked {
    /** What the machine makes by itself. */
    private static final List<String> SPECIAL =
            List.of(
                    "java/lang/Object",
                    "java/lang/Throwable",
                    "java/lang/Error",
                    "java/lang/OutOfMemoryError",
                    "[Ljava/lang/Object;",
                    "java/lang/NoSuchMethodError",
                    "java/lang/StackOverflowError",
                    "java/lang/NullPointerException",
                    "[Z",
                    "[C",
                    "[F",
                    "[D",
                    "[B",
                    "[S",
                    "[I",
                    "[J",
                    "java/lang/ClassCastException",
                    "java/lang/ArithmeticException",
                    "java/lang/ArrayIndexOutOfBoundsException",
                    "java/lang/IllegalArgumentException",
                    "java/lang/InterruptedException",
                    "java/lang/IllegalStateException",
                    "java/lang/IllegalMonitorStateException",
                    "java/lang/ThreadDeath",
                    "java/lang/ArrayStoreException",
                    "java/lang/NegativeArraySizeException",
                    "java/lang/Class",
                    "java/lang/String",
                    "java/lang/Cloneable",
                    "java/lang/Thread");

    /** Exceptions that methods of these handle. */
    private static final List<String> CAUGHT =
            List.of(
                    "java/io/IOException",
                    "java/lang/InterruptedException",
                    "java/lang/NumberFormatException",
                    "java/lang/Throwable");

    private static final String THREAD = "java/lang/Thread";
    private static final String RUN = "run()V";
    private static final String START = "<clinit>()V";
    private static final List<String> CALLED_BY_MACHINE =
            List.of("systemUncaughtExceptionHandler(Ljava/lang/Throwable;II)V", "exitThread()V");

    private final LinkedTypes types;

    /** Classes that are kept: internal names, of arrays descriptors. */
    private final Set<String> kept = new LinkedHashSet<>();

    /** Those of which there may be objects. */
    private final Set<String> made = new LinkedHashSet<>();

    private final Map<String, Set<String>> implementors = new HashMap<>();
    private final Map<Method, Set<Method>> overriding = new HashMap<>();
    private final Map<Method, LinkedType.Body> followed = new HashMap<>();
    private final Deque<Method> open = new ArrayDeque<>();

    private Linked(LinkedTypes types) {
        this.types = types;
    }

    /** The program that begins with some methods; without any it is empty. */
    static Linked from(Collection<MethodName> starts, Code code, LibraryLinks library) {
        Linked linked = new Linked(new LinkedTypes(code, library));
        SPECIAL.forEach(linked::object);
        CAUGHT.forEach(linked::keep);
        for (MethodName each : starts) {
            linked.object(each.owner());
        }
        linked.exceptions(starts);
        int before;
        do {
            before = linked.size();
            linked.round(starts);
        } while (before != linked.size());
        return linked;
    }

    private int size() {
        return kept.size() + made.size();
    }

    private void round(Collection<MethodName> starts) {
        followed.clear();
        for (String each : List.copyOf(made)) {
            implement(each);
            override(each);
        }
        for (String each : List.copyOf(kept)) {
            start(each, RUN);
            start(each, START);
        }
        CALLED_BY_MACHINE.forEach(each -> call(new Method(THREAD, each), true));
        starts.forEach(
                each -> call(new Method(each.owner(), each.name() + each.descriptor()), true));
        followAll();
    }

    private void start(String type, String signature) {
        LinkedType own = isArray(type) ? null : types.type(type);
        if (own != null && own.methods().containsKey(signature)) {
            call(new Method(type, signature), true);
        }
    }

    private void followAll() {
        while (!open.isEmpty()) {
            Method method = open.pop();
            List.copyOf(overriding.getOrDefault(method, Set.of()))
                    .forEach(each -> call(each, false));
            Objects.requireNonNull(followed.get(method)).uses().forEach(this::use);
        }
    }

    private void use(LinkedType.Use use) {
        switch (use.kind()) {
            case OBJECT -> object(use.type());
            case CLASS -> keep(use.type());
            case DIRECT -> call(types.inClasses(use.type(), use.signature()), true);
            case VIRTUAL -> call(types.virtual(use.type(), use.signature()), true);
            case INTERFACE -> call(types.inInterfaces(use.type(), use.signature()), true);
            default -> throw new IllegalStateException(use.toString());
        }
    }

    /**
     * A method that is declared may be called; null for none.
     *
     * @param isNamed whether an instruction names it
     */
    private void call(@Nullable Method method, boolean isNamed) {
        if (method == null) {
            return;
        }
        LinkedType owner = types.type(method.owner());
        LinkedType.Body body = owner == null ? null : owner.methods().get(method.signature());
        if (body == null) {
            return;
        }
        if (isNamed && body.isStatic()) {
            keep(method.owner());
        } else if (isNamed) {
            object(method.owner());
        }
        if (followed.putIfAbsent(method, body) == null) {
            open.push(method);
            for (String each : implementors.getOrDefault(method.owner(), Set.of())) {
                call(types.inClasses(each, method.signature()), false);
            }
        }
    }

    private void keep(String name) {
        if (isArray(name)) {
            kept.add(name);
            keep(element(name));
        } else if (!isPrimitive(name) && kept.add(name)) {
            LinkedType type = types.type(name);
            if (type != null) {
                type.parent().ifPresent(this::keep);
            }
        }
    }

    private void object(String name) {
        keep(name);
        if (isArray(name)) {
            object(element(name));
        } else if (!isPrimitive(name) && made.add(name)) {
            LinkedType type = types.type(name);
            if (type != null) {
                type.parent().ifPresent(this::object);
            }
        }
    }

    private static boolean isArray(String name) {
        return name.startsWith("[");
    }

    private static boolean isPrimitive(String name) {
        return name.length() == 1 && "ZCFDBSIJV".contains(name);
    }

    private static String element(String array) {
        Type element = Type.getType(array.substring(1));
        return element.getSort() == Type.OBJECT
                ? element.getInternalName()
                : element.getDescriptor();
    }

    private void implement(String user) {
        for (String type : types.lineage(user)) {
            for (String each : types.withInterfaces(type)) {
                if (!each.equals(type)) {
                    implementors.computeIfAbsent(each, k -> new LinkedHashSet<>()).add(user);
                }
            }
        }
    }

    private void override(String type) {
        LinkedType own = types.type(type);
        if (own == null || own.parent().isEmpty()) {
            return;
        }
        own.methods()
                .forEach(
                        (signature, body) -> {
                            if (!body.isStatic() && !signature.startsWith("<")) {
                                Method above = types.virtual(own.parent().get(), signature);
                                if (above != null) {
                                    overriding
                                            .computeIfAbsent(above, k -> new LinkedHashSet<>())
                                            .add(new Method(type, signature));
                                }
                            }
                        });
    }

    /** Of all classes that are read, used or not. */
    private void exceptions(Collection<MethodName> starts) {
        Set<String> seen = new HashSet<>();
        Deque<String> waiting = new ArrayDeque<>();
        starts.forEach(each -> waiting.add(each.owner()));
        while (!waiting.isEmpty()) {
            String name = waiting.pop();
            while (isArray(name)) {
                name = element(name);
            }
            LinkedType type = isPrimitive(name) || !seen.add(name) ? null : types.type(name);
            if (type != null) {
                type.caught().forEach(this::keep);
                waiting.addAll(type.named());
            }
        }
    }

    /** Internal names of classes and descriptors of arrays, the program's own and leJOS'. */
    Set<String> names() {
        return kept;
    }

    /** Whether all classes are known, so that these are what the linker keeps. */
    boolean isComplete() {
        return types.areComplete();
    }

    /** Classes that instructions of the program itself use. */
    Set<String> usedByProgram() {
        Set<String> used = new LinkedHashSet<>();
        followed.forEach(
                (method, body) -> {
                    if (types.isOfProgram(method.owner())) {
                        body.uses().forEach(use -> used.add(use.type()));
                    }
                });
        return used;
    }
}
