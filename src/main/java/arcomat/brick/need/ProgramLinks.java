package arcomat.brick.need;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FieldInsnNode;
import org.objectweb.asm.tree.LdcInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.MultiANewArrayInsnNode;
import org.objectweb.asm.tree.TryCatchBlockNode;
import org.objectweb.asm.tree.TypeInsnNode;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Reads from a class of the program what it uses. */
final class ProgramLinks {
    private static final String OBJECT = "java/lang/Object";

    private final Set<String> caught = new HashSet<>();
    private final Set<String> named = new HashSet<>();

    private ProgramLinks() {}

    static LinkedType of(ClassNode node) {
        ProgramLinks links = new ProgramLinks();
        Map<String, LinkedType.Body> methods = new HashMap<>();
        for (MethodNode each : node.methods) {
            methods.put(each.name + each.desc, links.body(each));
        }
        node.innerClasses.forEach(each -> links.named.add(each.name));
        Optional<String> parent = Optional.ofNullable(node.superName);
        parent.ifPresent(links.named::add);
        links.named.addAll(node.interfaces);
        links.named.remove(null); // of a damaged class
        return new LinkedType(parent, node.interfaces, methods, links.caught, links.named);
    }

    private LinkedType.Body body(MethodNode method) {
        List<LinkedType.Use> uses = new ArrayList<>();
        for (AbstractInsnNode each : method.instructions) {
            use(each).ifPresent(uses::add);
        }
        for (TryCatchBlockNode each : method.tryCatchBlocks) {
            if (each.type != null) {
                caught.add(each.type);
                named.add(each.type);
            }
        }
        named.addAll(method.exceptions);
        uses.forEach(each -> named.add(each.type()));
        return new LinkedType.Body((method.access & Opcodes.ACC_STATIC) != 0, uses);
    }

    private Optional<LinkedType.Use> use(AbstractInsnNode instruction) {
        if (instruction instanceof MethodInsnNode call) {
            return Optional.of(call(call));
        } else if (instruction instanceof FieldInsnNode field) {
            named.add(field.owner);
            return isStatic(field) && !isPrimitiveClass(field)
                    ? Optional.of(new LinkedType.Use(LinkedType.Kind.CLASS, field.owner, ""))
                    : Optional.empty();
        } else if (instruction instanceof MultiANewArrayInsnNode array) {
            return Optional.of(object(array.desc));
        } else if (instruction instanceof TypeInsnNode type) {
            return Optional.of(
                    object(type.getOpcode() == Opcodes.ANEWARRAY ? arrayOf(type.desc) : type.desc));
        } else if (instruction instanceof LdcInsnNode constant
                && constant.cst instanceof Type type) {
            return Optional.of(
                    new LinkedType.Use(LinkedType.Kind.CLASS, type.getInternalName(), ""));
        }
        return Optional.empty();
    }

    private static LinkedType.Use call(MethodInsnNode call) {
        String owner = call.owner.startsWith("[") ? OBJECT : call.owner;
        LinkedType.Kind kind =
                switch (call.getOpcode()) {
                    case Opcodes.INVOKEINTERFACE -> LinkedType.Kind.INTERFACE;
                    case Opcodes.INVOKEVIRTUAL -> LinkedType.Kind.VIRTUAL;
                    default -> LinkedType.Kind.DIRECT;
                };
        return new LinkedType.Use(kind, owner, call.name + call.desc);
    }

    private static LinkedType.Use object(String type) {
        return new LinkedType.Use(LinkedType.Kind.OBJECT, type, "");
    }

    private static String arrayOf(String type) {
        return "[" + Type.getObjectType(type).getDescriptor();
    }

    private static boolean isStatic(FieldInsnNode field) {
        return field.getOpcode() == Opcodes.GETSTATIC || field.getOpcode() == Opcodes.PUTSTATIC;
    }

    /** The class of a primitive type, such as Integer.TYPE, is no variable for the linker. */
    private static boolean isPrimitiveClass(FieldInsnNode field) {
        return field.name.equals("TYPE") && field.owner.startsWith("java/lang/");
    }
}
