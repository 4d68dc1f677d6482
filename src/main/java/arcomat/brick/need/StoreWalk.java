package arcomat.brick.need;

import arcomat.brick.api.BrickCost;
import arcomat.brick.need.flow.FlowGraph;
import arcomat.brick.need.flow.MethodName;
import arcomat.brick.need.flow.Unknown;

import org.jspecify.annotations.Nullable;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.FieldInsnNode;
import org.objectweb.asm.tree.FieldNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.analysis.BasicValue;

import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/**
 * Goes the ways through methods that can be gone with what objects hold: one way where a condition
 * is known, and otherwise both. What is not looked into weighs what {@link MethodWeights} says, and
 * writes whatever it may write.
 */
class StoreWalk {
    private final Code code;
    private final MethodWeights weights;
    private final FieldWrites effects;

    /** What others write at any time. */
    private final Set<String> shared;

    private final boolean keepsObjects;
    private final Map<MethodNode, Body> bodies = new HashMap<>();

    /** How many instructions are looked at yet; beyond, nothing is said. */
    private long patience = 200_000;

    private int depth;

    /**
     * @param keepsObjects whether it is known which object is which of those that are made
     */
    StoreWalk(Code code, MethodWeights weights, boolean keepsObjects) {
        this.code = code;
        this.weights = weights;
        this.effects = new FieldWrites(code);
        this.shared = effects.ofCallbacks();
        this.keepsObjects = keepsObjects;
    }

    /** A method, its graph, and what lies on ways to its returns. */
    record Body(MethodNode method, FlowGraph graph, BitSet useful) {}

    /**
     * What a method leaves behind.
     *
     * @param result null for none
     */
    record End(@Nullable BasicValue result, Store store) {}

    /**
     * How a method can end, and what the heaviest way to each end weighs.
     *
     * @param arguments the object that it is called on first
     * @throws Unknown if that takes too long to find out
     */
    final Map<End, Long> ends(MethodName name, List<? extends BasicValue> arguments, Store store) {
        if (depth == BrickCost.FRAMES) {
            throw new Unknown("too many calls wait for each other");
        }
        depth++;
        try {
            return new Ways(this, body(name)).from(arguments, store);
        } finally {
            depth--;
        }
    }

    private Body body(MethodName name) {
        return bodies.computeIfAbsent(
                code.method(name).orElseThrow(),
                method -> {
                    Operations.verify(name, method);
                    FlowGraph graph = new FlowGraph(method);
                    return new Body(method, graph, weights.useful(graph));
                });
    }

    /** What an instruction weighs that is no call. */
    long weight(AbstractInsnNode instruction) {
        return weights.own(instruction);
    }

    boolean keepsObjects() {
        return keepsObjects;
    }

    /** What is looked at costs the more the more is known. */
    void spend(Store store) {
        patience -= 1 + store.size() / 16;
        if (patience < 0) {
            throw new Unknown("there are too many ways to go");
        }
    }

    /** How a call can end. */
    Map<End, Long> called(MethodInsnNode call, List<BasicValue> arguments, Store store) {
        Optional<MethodName> target = target(call, arguments, store);
        if (target.filter(this::isLookedInto).isPresent()) {
            Map<End, Long> ends = new HashMap<>();
            long own = weights.own(call);
            ends(target.get(), arguments, store).forEach((end, way) -> ends.put(end, own + way));
            return ends;
        }
        BasicValue result = Operations.unknown(Type.getReturnType(call.desc));
        return Map.of(new End(result, store.without(effects.of(call))), weights.of(call));
    }

    /** The only method that a call can mean. */
    private Optional<MethodName> target(
            MethodInsnNode call, List<BasicValue> arguments, Store store) {
        MethodName named = MethodName.of(call);
        if (weights.isWeighedAtOnce(call)) {
            return Optional.empty();
        }
        if (call.getOpcode() == Opcodes.INVOKESTATIC || call.getOpcode() == Opcodes.INVOKESPECIAL) {
            return code.declaration(named);
        }
        return arguments.get(0) instanceof KnownValue known
                ? code.declaration(named.in(store.objects().get(known.number())))
                : Optional.empty();
    }

    private boolean isLookedInto(MethodName method) {
        return weights.isWalked(method)
                && code.method(method)
                        .filter(body -> body.instructions.size() > 0)
                        .filter(body -> body.tryCatchBlocks.isEmpty())
                        .isPresent();
    }

    /** With a new object of a class, whose fields hold nothing yet. */
    Store made(String type, Store store) {
        Map<String, KnownValue> fields = new HashMap<>();
        for (String each : code.withSupertypes(type)) {
            for (FieldNode field : code.type(each).map(node -> node.fields).orElse(List.of())) {
                String name = FieldWrites.name(each, field.name);
                if (!shared.contains(name)) {
                    KnownValue.nothing(field.desc).ifPresent(nothing -> fields.put(name, nothing));
                }
            }
        }
        return store.made(type, fields);
    }

    BasicValue read(FieldInsnNode access, BasicValue object, Store store) {
        KnownValue held = null;
        if (object instanceof KnownValue known) {
            held = store.fields().get(new Store.Field(known.number(), effects.name(access)));
        }
        return held != null
                ? held
                : Objects.requireNonNull(Operations.unknown(Type.getType(access.desc)));
    }

    /** What is written to an object that is not known may be written to any. */
    Store write(FieldInsnNode access, BasicValue object, BasicValue value, Store store) {
        String name = effects.name(access);
        if (shared.contains(name)) {
            return store;
        }
        return object instanceof KnownValue known
                ? store.with(new Store.Field(known.number(), name), value)
                : store.without(Set.of(name));
    }
}
