package arcomat.brick;

import arcomat.brick.api.BrickTable;
import arcomat.brick.api.BrickType;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.MultiANewArrayInsnNode;
import org.objectweb.asm.tree.TypeInsnNode;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Collection;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Estimates how many classes the linked program has. Which of leJOS' classes another one needs is
 * written in bodies that the table does not have; what its head and its members name stands for
 * that. Measured with the linker: 75 for the empty program, about 110 for motors, ultrasonic and
 * light sensor without the robot's own classes.
 */
final class LinkedClasses {
    /** Classes of the empty program, as the linker counts them. */
    static final int EMPTY_PROGRAM = 75;

    /** What every program needs, besides the exceptions that the machine itself throws. */
    private static final List<String> ALWAYS =
            List.of("java/lang/Object", "java/lang/String", "java/lang/System", "java/lang/Thread");

    private final BrickTable table;

    /** Internal names of classes, descriptors of arrays. */
    private final Set<String> reached = new HashSet<>();

    private final Deque<BrickType> waiting = new ArrayDeque<>();

    private LinkedClasses(BrickTable table) {
        this.table = table;
    }

    /** The empty program, own classes and arrays, and what of leJOS is not in the empty program. */
    static int about(Program program) {
        LinkedClasses linked = new LinkedClasses(program.table());
        program.references().forEach(reference -> linked.reachClass(reference.owner()));
        program.inClasses((file, node) -> arrays(node)).forEach(linked::reach);
        linked.follow();
        linked.reached.removeAll(emptyProgram(program.table()));
        return EMPTY_PROGRAM + program.files().size() + linked.reached.size();
    }

    private static Set<String> emptyProgram(BrickTable table) {
        LinkedClasses linked = new LinkedClasses(table);
        ALWAYS.forEach(linked::reachClass);
        table.types().stream()
                .filter(type -> type.packageName().equals("java/lang"))
                .filter(type -> isThrowable(table, type))
                .forEach(type -> linked.reachClass(type.name()));
        linked.follow();
        return linked.reached;
    }

    private static boolean isThrowable(BrickTable table, BrickType type) {
        return type.name().equals("java/lang/Throwable")
                || type.superclass()
                        .flatMap(table::type)
                        .filter(s -> isThrowable(table, s))
                        .isPresent();
    }

    /** The arrays that a class makes, and those it declares fields for. */
    private static Stream<Type> arrays(ClassNode node) {
        Stream<Type> fields = node.fields.stream().map(field -> Type.getType(field.desc));
        Stream<Type> made =
                node.methods.stream()
                        .flatMap(method -> Arrays.stream(method.instructions.toArray()))
                        .flatMap(instruction -> arrayMadeBy(instruction).stream());
        return Stream.concat(fields, made);
    }

    private static Optional<Type> arrayMadeBy(AbstractInsnNode instruction) {
        if (instruction instanceof MultiANewArrayInsnNode several) {
            return Optional.of(Type.getType(several.desc));
        }
        if (instruction instanceof TypeInsnNode one && one.getOpcode() == Opcodes.ANEWARRAY) {
            return Optional.of(Type.getType("[" + Type.getObjectType(one.desc).getDescriptor()));
        }
        return Optional.empty();
    }

    private void reachNames(String descriptor) {
        Type type = Type.getType(descriptor);
        if (type.getSort() == Type.METHOD) {
            reach(type.getReturnType());
            Stream.of(type.getArgumentTypes()).forEach(this::reach);
        } else {
            reach(type);
        }
    }

    private void reach(Type type) {
        if (type.getSort() == Type.OBJECT) {
            reachClass(type.getInternalName());
        } else if (type.getSort() == Type.ARRAY && type.getElementType().getSort() == Type.OBJECT) {
            // Arrays of numbers are in the empty program.
            reached.add(type.getDescriptor());
            reach(type.getElementType());
        }
    }

    private void reachClass(String name) {
        table.type(name).filter(type -> reached.add(name)).ifPresent(waiting::add);
    }

    private void follow() {
        while (!waiting.isEmpty()) {
            named(waiting.remove());
        }
    }

    private void named(BrickType type) {
        type.superclass().ifPresent(this::reachClass);
        type.interfaces().forEach(this::reachClass);
        type.fields().forEach(field -> reachNames(field.descriptor()));
        type.methods().forEach(method -> reachNames(method.descriptor()));
        type.methods().stream()
                .map(method -> method.exceptions())
                .flatMap(Collection::stream)
                .forEach(this::reachClass);
        if (!type.name().startsWith("java/")) {
            // Drivers are made of their nested classes; the collections of java.util are not.
            table.nestedIn(type.name()).forEach(inner -> reachClass(inner.name()));
        }
    }
}
