package arcomat.brick.need;

import arcomat.brick.need.flow.MethodName;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.FieldInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;

import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Which fields of objects methods may write, with all that they call. */
final class FieldWrites {
    private final Code code;
    private final Map<MethodName, Set<String>> known = new HashMap<>();

    FieldWrites(Code code) {
        this.code = code;
    }

    /** A field with the class that declares it. */
    String name(FieldInsnNode access) {
        return code.withSupertypes(access.owner).stream()
                .filter(type -> isDeclared(type, access.name))
                .findFirst()
                .map(type -> name(type, access.name))
                .orElse(name(access.owner, access.name));
    }

    static String name(String type, String field) {
        return type + "." + field;
    }

    private boolean isDeclared(String type, String field) {
        return code.type(type).stream()
                .flatMap(node -> node.fields.stream())
                .anyMatch(each -> each.name.equals(field));
    }

    /** What a call may write: what it reaches, and what leJOS may call back. */
    Set<String> of(MethodInsnNode call) {
        Set<String> written = new HashSet<>();
        for (MethodName target : code.targets(call)) {
            written.addAll(known.computeIfAbsent(target, t -> reached(List.of(t))));
        }
        return written;
    }

    /** What methods may write that leJOS calls by itself, its threads and listeners among them. */
    Set<String> ofCallbacks() {
        return reached(code.methods().stream().filter(this::isCallback).toList());
    }

    private boolean isCallback(MethodName method) {
        return !method.name().startsWith("<")
                && code.withSupertypes(method.owner()).stream()
                        .flatMap(type -> code.library(type).stream())
                        .anyMatch(t -> t.method(method.name(), method.descriptor()).isPresent());
    }

    private Set<String> reached(Collection<MethodName> first) {
        Set<String> written = new HashSet<>();
        Set<MethodName> seen = new HashSet<>(first);
        Deque<MethodName> open = new ArrayDeque<>(first);
        while (!open.isEmpty()) {
            for (AbstractInsnNode each : instructions(open.remove())) {
                if (each.getOpcode() == Opcodes.PUTFIELD) {
                    written.add(name((FieldInsnNode) each));
                } else if (each instanceof MethodInsnNode call) {
                    code.targets(call).stream().filter(seen::add).forEach(open::add);
                }
            }
        }
        return written;
    }

    private AbstractInsnNode[] instructions(MethodName method) {
        return code.method(method)
                .map(body -> body.instructions.toArray())
                .orElse(new AbstractInsnNode[0]);
    }
}
