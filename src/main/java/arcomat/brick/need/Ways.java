package arcomat.brick.need;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.FieldInsnNode;
import org.objectweb.asm.tree.JumpInsnNode;
import org.objectweb.asm.tree.LabelNode;
import org.objectweb.asm.tree.LookupSwitchInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.TableSwitchInsnNode;
import org.objectweb.asm.tree.TypeInsnNode;
import org.objectweb.asm.tree.analysis.BasicValue;
import org.objectweb.asm.tree.analysis.Frame;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.PriorityQueue;
import java.util.stream.IntStream;

/** The ways through one call of a method. */
final class Ways {
    private final StoreWalk walk;
    private final StoreWalk.Body body;
    private final Map<Place, Long> heaviest = new HashMap<>();
    private final PriorityQueue<Place> open =
            new PriorityQueue<>((one, other) -> Integer.compare(one.position(), other.position()));
    private final Map<StoreWalk.End, Long> ends = new HashMap<>();

    Ways(StoreWalk walk, StoreWalk.Body body) {
        this.walk = walk;
        this.body = body;
    }

    /**
     * Where ways come together that do not differ in what they know.
     *
     * @param values of locals and stack
     */
    private record Place(int position, List<BasicValue> values, Store store) {}

    /** A way up to an instruction; the frame is its own. */
    private record Way(int position, Frame<BasicValue> frame, Store store, long weight) {
        Way at(int next) {
            return new Way(next, new Frame<>(frame), store, weight);
        }

        Way then(Store after) {
            return new Way(position + 1, frame, after, weight);
        }

        BasicValue pop() {
            return frame.pop();
        }

        List<BasicValue> pop(int count) {
            List<BasicValue> values = new ArrayList<>();
            for (int i = 0; i < count; i++) {
                values.add(0, pop());
            }
            return values;
        }
    }

    Map<StoreWalk.End, Long> from(List<? extends BasicValue> arguments, Store store) {
        Frame<BasicValue> frame = frame();
        for (int i = 0; i < frame.getLocals(); i++) {
            frame.setLocal(i, BasicValue.UNINITIALIZED_VALUE);
        }
        int local = 0;
        for (BasicValue each : arguments) {
            frame.setLocal(local, each);
            local += each.getSize();
        }
        if (body.useful().get(0)) {
            arrive(new Way(0, frame, store, 0));
        }
        while (!open.isEmpty()) {
            Place place = open.remove();
            follow(new Way(place.position(), frame(place), place.store(), weight(place)));
        }
        return ends;
    }

    private long weight(Place place) {
        return Objects.requireNonNull(heaviest.get(place));
    }

    private Frame<BasicValue> frame() {
        return new Frame<>(body.method().maxLocals, body.method().maxStack);
    }

    private Frame<BasicValue> frame(Place place) {
        Frame<BasicValue> frame = frame();
        for (int i = 0; i < place.values().size(); i++) {
            if (i < frame.getLocals()) {
                frame.setLocal(i, place.values().get(i));
            } else {
                frame.push(place.values().get(i));
            }
        }
        return frame;
    }

    private void arrive(Way way) {
        List<BasicValue> values = new ArrayList<>();
        for (int i = 0; i < way.frame().getLocals(); i++) {
            values.add(way.frame().getLocal(i));
        }
        for (int i = 0; i < way.frame().getStackSize(); i++) {
            values.add(way.frame().getStack(i));
        }
        Place place = new Place(way.position(), values, way.store());
        Long before = heaviest.get(place);
        if (before == null || before < way.weight()) {
            heaviest.put(place, way.weight());
            open.add(place);
        }
    }

    /** Up to where ways part or come together. */
    private void follow(Way from) {
        List<Way> ways = List.of(from);
        do {
            Way way = ways.get(0);
            walk.spend(way.store());
            ways = step(way).stream().filter(each -> body.useful().get(each.position())).toList();
        } while (ways.size() == 1 && body.graph().before(ways.get(0).position()).size() == 1);
        ways.forEach(this::arrive);
    }

    private List<Way> step(Way before) {
        AbstractInsnNode each = body.graph().instruction(before.position());
        if (each instanceof MethodInsnNode call) {
            return called(call, before);
        }
        long weight = before.weight() + walk.weight(each);
        Way way = new Way(before.position(), before.frame(), before.store(), weight);
        if (each instanceof JumpInsnNode jump) {
            return jumped(jump, way);
        } else if (each instanceof TableSwitchInsnNode choice) {
            int keys = choice.labels.size();
            List<Integer> all = IntStream.range(choice.min, choice.min + keys).boxed().toList();
            return chosen(all, choice.labels, choice.dflt, way);
        } else if (each instanceof LookupSwitchInsnNode choice) {
            return chosen(choice.keys, choice.labels, choice.dflt, way);
        } else if (each instanceof FieldInsnNode access && isOfObject(each)) {
            return accessed(access, way);
        } else if (each.getOpcode() == Opcodes.NEW && walk.keepsObjects()) {
            Store with = walk.made(((TypeInsnNode) each).desc, way.store());
            way.frame().push(KnownValue.object(way.store().objects().size()));
            return List.of(way.then(with));
        } else if (body.graph().after(way.position()).isEmpty()) {
            ends(each, way);
            return List.of();
        } else if (each.getOpcode() >= 0) {
            Operations.execute(each, way.frame());
        }
        return List.of(way.then(way.store()));
    }

    /** A return; what throws has no way to go on, either. */
    private void ends(AbstractInsnNode last, Way way) {
        BasicValue result = last.getOpcode() == Opcodes.RETURN ? null : way.pop();
        ends.merge(new StoreWalk.End(result, way.store()), way.weight(), Math::max);
    }

    private List<Way> jumped(JumpInsnNode jump, Way way) {
        int target = body.graph().position(jump.label);
        if (jump.getOpcode() == Opcodes.GOTO) {
            return List.of(way.at(target));
        }
        boolean ofTwo =
                jump.getOpcode() >= Opcodes.IF_ICMPEQ && jump.getOpcode() <= Opcodes.IF_ACMPNE;
        BasicValue second = way.pop();
        BasicValue first = ofTwo ? way.pop() : second;
        List<Way> both = List.of(way.at(target), way.at(way.position() + 1));
        return Operations.isTaken(jump.getOpcode(), first, second)
                .map(taken -> both.subList(taken ? 0 : 1, taken ? 1 : 2))
                .orElse(both);
    }

    private List<Way> chosen(
            List<Integer> keys, List<LabelNode> labels, LabelNode otherwise, Way way) {
        if (way.pop() instanceof KnownValue known) {
            int key = keys.indexOf(known.number());
            return List.of(way.at(body.graph().position(key < 0 ? otherwise : labels.get(key))));
        }
        return body.graph().after(way.position()).stream().map(way::at).toList();
    }

    private static boolean isOfObject(AbstractInsnNode access) {
        return access.getOpcode() == Opcodes.GETFIELD || access.getOpcode() == Opcodes.PUTFIELD;
    }

    private List<Way> accessed(FieldInsnNode access, Way way) {
        boolean writes = access.getOpcode() == Opcodes.PUTFIELD;
        List<BasicValue> operands = way.pop(writes ? 2 : 1);
        BasicValue object = operands.get(0);
        if (object.equals(KnownValue.NULL)) {
            return List.of();
        } else if (writes) {
            return List.of(way.then(walk.write(access, object, operands.get(1), way.store())));
        }
        way.frame().push(walk.read(access, object, way.store()));
        return List.of(way.then(way.store()));
    }

    private List<Way> called(MethodInsnNode call, Way way) {
        boolean isStatic = call.getOpcode() == Opcodes.INVOKESTATIC;
        int count = Type.getArgumentTypes(call.desc).length + (isStatic ? 0 : 1);
        List<BasicValue> arguments = way.pop(count);
        if (!isStatic && arguments.get(0).equals(KnownValue.NULL)) {
            return List.of();
        }
        List<Way> ways = new ArrayList<>();
        walk.called(call, arguments, way.store())
                .forEach((end, weight) -> ways.add(after(end, way, weight)));
        return ways;
    }

    private static Way after(StoreWalk.End end, Way way, long weight) {
        Frame<BasicValue> frame = new Frame<>(way.frame());
        if (end.result() != null) {
            frame.push(end.result());
        }
        return new Way(way.position() + 1, frame, end.store(), way.weight() + weight);
    }
}
