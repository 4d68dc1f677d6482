package arcomat.brick.need;

import arcomat.brick.api.BrickTable;
import arcomat.brick.api.BrickType;
import arcomat.brick.need.flow.MethodName;

import org.jspecify.annotations.Nullable;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** The classes of a program, and which of its methods a call may reach. */
final class Code {
    private final Map<String, ClassNode> classes = new LinkedHashMap<>();
    private final Map<MethodName, MethodNode> methods = new HashMap<>();
    private final Map<String, List<String>> subtypes = new HashMap<>();
    private final BrickTable table;

    Code(Collection<ClassNode> classes, BrickTable table) {
        this.table = table;
        for (ClassNode each : classes) {
            this.classes.put(each.name, each);
            each.methods.forEach(m -> methods.put(new MethodName(each.name, m.name, m.desc), m));
        }
        for (ClassNode each : classes) {
            for (String supertype : supertypes(each.name)) {
                subtypes.computeIfAbsent(supertype, s -> new ArrayList<>()).add(each.name);
            }
        }
    }

    /** The same without some classes. */
    Code without(Collection<String> names) {
        return new Code(
                classes.values().stream().filter(each -> !names.contains(each.name)).toList(),
                table);
    }

    /** All methods of the program itself. */
    Set<MethodName> methods() {
        return methods.keySet();
    }

    Collection<ClassNode> classes() {
        return classes.values();
    }

    Optional<ClassNode> type(String name) {
        return Optional.ofNullable(classes.get(name));
    }

    /** A class of the brick. */
    Optional<BrickType> library(String name) {
        return table.type(name);
    }

    /** The program's own method, declared in the class that is named and nowhere else. */
    Optional<MethodNode> method(MethodName name) {
        return Optional.ofNullable(methods.get(name));
    }

    /** The program's own types below one of its own or leJOS'. */
    List<String> subtypes(String type) {
        return subtypes.getOrDefault(type, List.of());
    }

    /** A type and all above it, its superclasses before its interfaces. */
    Set<String> withSupertypes(String type) {
        Set<String> all = new LinkedHashSet<>();
        // A damaged class may be above itself.
        String superclass = type;
        while (superclass != null && all.add(superclass)) {
            superclass = superclass(superclass);
        }
        Deque<String> open = new ArrayDeque<>(all);
        while (!open.isEmpty()) {
            for (String each : interfaces(open.remove())) {
                if (all.add(each)) {
                    open.add(each);
                }
            }
        }
        return all;
    }

    private Set<String> supertypes(String type) {
        Set<String> all = withSupertypes(type);
        all.remove(type);
        return all;
    }

    /** None for objects, for interfaces it is objects. */
    private @Nullable String superclass(String type) {
        ClassNode own = classes.get(type);
        return own != null
                ? own.superName
                : table.type(type).flatMap(BrickType::superclass).orElse(null);
    }

    private List<String> interfaces(String type) {
        ClassNode own = classes.get(type);
        return own != null
                ? own.interfaces
                : table.type(type).map(BrickType::interfaces).orElse(List.of());
    }

    /** Where a method is declared: in a type or above it, the program's own or leJOS'. */
    Optional<MethodName> declaration(MethodName named) {
        return withSupertypes(named.owner()).stream()
                .map(named::in)
                .filter(this::isDeclared)
                .findFirst();
    }

    private boolean isDeclared(MethodName name) {
        return methods.containsKey(name)
                || table.type(name.owner())
                        .flatMap(t -> t.method(name.name(), name.descriptor()))
                        .isPresent();
    }

    /**
     * Whatever may run where a method is called: declarations, of which leJOS' have no body here.
     */
    Set<MethodName> targets(MethodInsnNode call) {
        MethodName named = MethodName.of(call);
        Set<MethodName> targets = new LinkedHashSet<>();
        // Private methods of leJOS are not in the table, nor are methods of arrays.
        targets.add(declaration(named).orElse(named));
        if (call.getOpcode() == Opcodes.INVOKEVIRTUAL
                || call.getOpcode() == Opcodes.INVOKEINTERFACE) {
            for (String subtype : subtypes(call.owner)) {
                declaration(named.in(subtype)).ifPresent(targets::add);
            }
            targets.removeIf(this::isAbstract);
        }
        return targets;
    }

    private boolean isAbstract(MethodName name) {
        MethodNode own = methods.get(name);
        return own != null && (own.access & Opcodes.ACC_ABSTRACT) != 0;
    }
}
