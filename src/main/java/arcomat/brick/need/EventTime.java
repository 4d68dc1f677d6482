package arcomat.brick.need;

import arcomat.brick.need.flow.Constants;
import arcomat.brick.need.flow.MethodName;
import arcomat.brick.need.flow.Unknown;
import arcomat.graph.Digraph;
import arcomat.graph.StrongComponents;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.FieldInsnNode;
import org.objectweb.asm.tree.InsnNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.analysis.BasicValue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * How long it takes to work off all events where each queue is full, and what follows from them. In
 * a round each part handles one event, as long as any waits; events that come meanwhile are left
 * aside. A part whose senders have nothing left has no more events than its queue holds.
 */
final class EventTime {
    /** From one round to the next, and a look at a queue that is empty: instructions. */
    private static final int ROUND = 10;

    private static final int LOOK = 6;

    private static final String PLACE = "place";
    private static final String PLACING = "(ILjava/lang/String;)I";

    private final Code code;
    private final MethodWeights weights;
    private final Store store;
    private final List<Part> parts;

    /** An object that has a queue of events. */
    private record Part(KnownValue object, MethodName react, long capacity) {}

    /**
     * @param weights of what slices do
     * @param store what objects are there before the first slice
     */
    EventTime(Code code, MethodWeights weights, Store store) {
        this.code = code;
        this.weights = weights;
        this.store = store.ofObjects();
        this.parts =
                IntStream.range(0, store.objects().size())
                        .boxed()
                        .flatMap(object -> part(object).stream())
                        .toList();
    }

    private Optional<Part> part(int object) {
        MethodName named = new MethodName(store.objects().get(object), "react", "()Z");
        return code.declaration(named)
                .flatMap(
                        react ->
                                code.method(new MethodName(react.owner(), PLACE, PLACING))
                                        .map(EventTime::capacity)
                                        .map(of -> new Part(KnownValue.object(object), react, of)));
    }

    /** The ring of places begins anew behind its last one. */
    private static long capacity(MethodNode place) {
        for (AbstractInsnNode each : place.instructions) {
            if (each.getOpcode() == Opcodes.IREM) {
                return Constants.pushed(Constants.before(each)).orElse(0);
            }
        }
        throw new Unknown("a queue is not made as others are");
    }

    /** The call that lets parts react, in the body of a slice; none where no events drive it. */
    static Optional<MethodInsnNode> reaction(MethodNode slice) {
        for (AbstractInsnNode each : slice.instructions) {
            if (each instanceof MethodInsnNode call
                    && call.name.equals("react")
                    && call.desc.equals("()Z")
                    && Constants.before(call) instanceof FieldInsnNode) {
                return Optional.of(call);
            }
        }
        return Optional.empty();
    }

    /**
     * @param reaction the call in a slice
     * @throws Unknown if parts may send each other events without end
     */
    long of(MethodInsnNode reaction) {
        Map<KnownValue, Long> handled = new HashMap<>();
        long rounds = 1 + follow(handled);
        long all = Math.multiplyExact(rounds, round(reaction));
        StoreWalk walk = new StoreWalk(code, weights, false);
        for (Part each : parts) {
            long one = reacting(each, walk);
            all = Math.addExact(all, Math.multiplyExact(known(handled, each.object()), one));
        }
        return all;
    }

    private static <K, V> V known(Map<K, V> values, K key) {
        return Objects.requireNonNull(values.get(key));
    }

    private static long heaviest(Map<StoreWalk.End, Long> ends) {
        return ends.values().stream().mapToLong(way -> way).max().orElse(0);
    }

    private long reacting(Part part, StoreWalk walk) {
        return heaviest(walk.ends(part.react(), List.of(part.object()), store));
    }

    /** A round in which all parts are asked, besides what those do that react. */
    private long round(MethodInsnNode reaction) {
        StoreWalk asking =
                new StoreWalk(code, weights, false) {
                    @Override
                    Map<End, Long> called(
                            MethodInsnNode call, List<BasicValue> arguments, Store before) {
                        boolean isOfPart =
                                call.name.equals(reaction.name)
                                        && parts.stream()
                                                .anyMatch(p -> p.object().equals(arguments.get(0)));
                        return isOfPart
                                ? Map.of(
                                        new End(Operations.unknown(Type.INT_TYPE), before),
                                        weights.own(call))
                                : super.called(call, arguments, before);
                    }
                };
        FieldInsnNode field = (FieldInsnNode) Constants.before(reaction);
        BasicValue whole = asking.read(field, SliceSearch.ROBOT, store);
        long instructions = ROUND + (long) LOOK * parts.size();
        return heaviest(asking.called(reaction, List.of(whole), store))
                + instructions * weights.own(new InsnNode(Opcodes.NOP));
    }

    /**
     * Finds out how many events each part handles.
     *
     * @return after how many rounds none waits any more
     */
    private long follow(Map<KnownValue, Long> handled) {
        Map<Part, Map<Part, Long>> senders = senders();
        Map<Part, Long> rounds = new HashMap<>();
        for (Part each : inOrder(senders)) {
            long events = each.capacity();
            long before = 0;
            for (Map.Entry<Part, Long> sender : known(senders, each).entrySet()) {
                before = Math.max(before, known(rounds, sender.getKey()));
                long sent = known(handled, sender.getKey().object()) * sender.getValue();
                events = Math.addExact(events, sent);
            }
            rounds.put(each, before + each.capacity());
            handled.put(each.object(), Math.min(events, before + each.capacity()));
        }
        return rounds.values().stream().mapToLong(round -> round).max().orElse(0);
    }

    /** For each part, how many events others send it at most when they handle one. */
    private Map<Part, Map<Part, Long>> senders() {
        Map<Part, Map<Part, Long>> senders = new HashMap<>();
        for (Part to : parts) {
            StoreWalk counting = counting(to);
            Map<Part, Long> sent = new HashMap<>();
            for (Part from : parts) {
                long events = reacting(from, counting);
                if (events > 0) {
                    sent.put(from, events);
                }
            }
            senders.put(to, sent);
        }
        return senders;
    }

    /** Counts the events that get a place in a part's queue. */
    private StoreWalk counting(Part to) {
        return new StoreWalk(code, weights.nothing(), false) {
            @Override
            Map<End, Long> called(MethodInsnNode call, List<BasicValue> arguments, Store before) {
                Map<End, Long> ends = super.called(call, arguments, before);
                if (!call.name.equals(PLACE) || !arguments.get(0).equals(to.object())) {
                    return ends;
                }
                Map<End, Long> counted = new HashMap<>();
                ends.forEach((end, events) -> counted.put(end, events + 1));
                return counted;
            }
        };
    }

    /** The parts, each behind those that send it something. */
    private List<Part> inOrder(Map<Part, Map<Part, Long>> senders) {
        Digraph sending = new Digraph(parts.size());
        senders.forEach(
                (to, from) ->
                        from.keySet()
                                .forEach(
                                        each ->
                                                sending.addEdge(
                                                        parts.indexOf(to), parts.indexOf(each))));
        List<Part> order = new ArrayList<>();
        for (int[] each : StrongComponents.of(sending).all()) {
            if (each.length > 1 || sending.successors(each[0]).contains(each[0])) {
                throw new Unknown("parts may send each other events without end");
            }
            order.add(parts.get(each[0]));
        }
        return order;
    }
}
