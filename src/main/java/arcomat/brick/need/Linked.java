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
import org.objectweb.asm.tree.TypeInsnNode;

import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.Set;
import java.util.TreeSet;

/**
 * What the linker keeps of a program, found as it does: from the main method it follows calls, and
 * keeps classes whose objects, arrays, statics or methods are used there; those that only fields or
 * parameters name, and interfaces that nobody calls, it drops. A method is followed wherever an
 * object that is made could be asked for it.
 */
final class Linked {
    private final Code code;
    private final Set<String> types = new LinkedHashSet<>();
    private final Set<MethodName> followed = new HashSet<>();
    private final Deque<MethodName> open = new ArrayDeque<>();
    private final Set<MethodInsnNode> calls = new LinkedHashSet<>();

    private Linked(Code code) {
        this.code = code;
    }

    /** Internal names of classes and descriptors of arrays, the program's own and leJOS'. */
    static Set<String> from(Collection<MethodName> starts, Code code) {
        Linked linked = new Linked(code);
        starts.forEach(start -> linked.method(start));
        linked.followAll();
        return new TreeSet<>(linked.types);
    }

    private void followAll() {
        int before;
        do {
            before = types.size() + followed.size();
            while (!open.isEmpty()) {
                code.method(open.pop()).ifPresent(this::follow);
            }
            // A call may reach what was made after it was looked at.
            Set.copyOf(calls).forEach(this::call);
        } while (before != types.size() + followed.size() || !open.isEmpty());
    }

    private void method(MethodName method) {
        type(method.owner());
        if (followed.add(method)) {
            open.push(method);
        }
    }

    private void call(MethodInsnNode call) {
        if (call.owner.startsWith("[")) {
            return; // arrays have the methods of objects
        }
        MethodName named = MethodName.of(call);
        MethodName declared = code.declaration(named).orElse(named);
        method(declared);
        for (MethodName target : code.targets(call)) {
            if (types.contains(target.owner())) {
                method(target);
            }
        }
    }

    private void follow(MethodNode method) {
        for (AbstractInsnNode each : method.instructions) {
            if (each instanceof MethodInsnNode i) {
                calls.add(i);
                call(i);
            } else if (each instanceof FieldInsnNode i) {
                if (i.getOpcode() == Opcodes.GETSTATIC || i.getOpcode() == Opcodes.PUTSTATIC) {
                    type(i.owner);
                }
            } else if (each instanceof MultiANewArrayInsnNode i) {
                array(Type.getType(i.desc));
            } else if (each instanceof TypeInsnNode i) {
                Type type = Type.getObjectType(i.desc);
                if (i.getOpcode() == Opcodes.ANEWARRAY) {
                    array(Type.getType("[" + type.getDescriptor()));
                } else {
                    type(i.desc);
                }
            } else if (each instanceof LdcInsnNode i && i.cst instanceof Type type) {
                type(type.getInternalName());
            }
        }
    }

    private void array(Type type) {
        types.add(type.getDescriptor());
        Type element = Type.getType(type.getDescriptor().substring(1));
        if (element.getSort() == Type.ARRAY) {
            array(element);
        } else if (element.getSort() == Type.OBJECT) {
            type(element.getInternalName());
        }
    }

    private void type(String name) {
        if (name.startsWith("[")) {
            array(Type.getObjectType(name));
        } else if (types.add(name)) {
            code.type(name).ifPresent(this::superclassAndStarts);
        }
    }

    /** The machine itself calls these. */
    private void superclassAndStarts(ClassNode node) {
        type(node.superName);
        for (MethodNode method : node.methods) {
            if (method.name.equals("<clinit>")
                    || method.name.equals("run") && method.desc.equals("()V")) {
                method(new MethodName(node.name, method.name, method.desc));
            }
        }
    }
}
