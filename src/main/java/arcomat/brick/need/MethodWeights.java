package arcomat.brick.need;

import arcomat.brick.need.flow.FlowGraph;
import arcomat.brick.need.flow.HeaviestPath;
import arcomat.brick.need.flow.MethodName;
import arcomat.brick.need.flow.Unknown;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;

import java.util.BitSet;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;

/** What methods weigh along their heaviest ways, with all that they call. */
abstract class MethodWeights {
    protected final Code code;
    protected final LibraryCost library;
    private static final Optional<String> TEXT = Optional.of(MonitorSize.TEXT);
    private final Map<String, Long> sizes;
    private final RobotMonitors monitors;
    private final Map<String, MethodWeights> ofMonitors = new HashMap<>();
    private final Map<MethodName, Long> known = new HashMap<>();
    private final Map<MethodName, Unknown> unknown = new HashMap<>();
    private final Set<MethodName> open = new HashSet<>();
    private final Map<MethodName, Boolean> returning = new HashMap<>();

    MethodWeights(Code code, LibraryCost library) {
        this(code, library, Map.of());
    }

    /**
     * @param sizes by the words that stand for them where loops have a bound
     */
    MethodWeights(Code code, LibraryCost library, Map<String, Long> sizes) {
        this.code = code;
        this.library = library;
        this.sizes = sizes;
        this.monitors = new RobotMonitors(code, library);
    }

    final MethodWeights nothing() {
        return none(code, library);
    }

    /** For who wants to know ways and not what they weigh. */
    static MethodWeights none(Code code, LibraryCost library) {
        return new MethodWeights(code, library) {
            @Override
            protected long own(AbstractInsnNode instruction) {
                return 0;
            }

            @Override
            protected long ofLibrary(MethodName method) {
                return 0;
            }
        };
    }

    /** An instruction's own weight; a call without what it calls. */
    protected abstract long own(AbstractInsnNode instruction);

    /** The weight of a method of leJOS. */
    protected abstract long ofLibrary(MethodName method);

    /** The same for what a monitor does; without, that weighs what it weighs for all at once. */
    protected MethodWeights ofMonitor(Code alone, Map<String, Long> ofIts) {
        return this;
    }

    /** Whether the code of a method of the program is to be weighed. */
    protected boolean isLookedInto(MethodName method) {
        return true;
    }

    /**
     * @throws Unknown if that cannot be told
     */
    final long of(MethodName method) {
        Unknown before = unknown.get(method);
        if (before != null) {
            throw before;
        }
        Long weight = known.get(method);
        if (weight == null) {
            weight = computed(method);
            known.put(method, weight);
        }
        return weight;
    }

    private long computed(MethodName method) {
        if (!open.add(method)) {
            throw Unknown.of(method, "calls itself");
        }
        try {
            Optional<MethodNode> body = code.method(method).filter(b -> isLookedInto(method));
            return body.isPresent() ? ofBody(method, body.get()) : ofLibrary(method);
        } catch (Unknown e) {
            Unknown named = e.in(method);
            unknown.put(method, named);
            throw named;
        } finally {
            open.remove(method);
        }
    }

    private long ofBody(MethodName method, MethodNode body) {
        FlowGraph graph = new FlowGraph(body);
        try {
            return HeaviestPath.of(graph, useful(graph), rounds(method), this::of);
        } catch (Unknown e) {
            throw library.rounds(method).equals(TEXT)
                    ? Unknown.of(method, "takes the longer, the longer a text is that is watched")
                    : e;
        }
    }

    private OptionalLong rounds(MethodName method) {
        return library.rounds(method).stream()
                .filter(each -> sizes.containsKey(each) || Character.isDigit(each.charAt(0)))
                .mapToLong(each -> sizes.containsKey(each) ? sizes.get(each) : Long.parseLong(each))
                .findFirst();
    }

    /** What lies on a way to a return, past calls that come back. */
    final BitSet useful(FlowGraph graph) {
        return graph.useful(i -> isEnd(graph.instruction(i)));
    }

    /** Whether the ways through a method can be gone one by one: its loops show when they end. */
    final boolean isWalked(MethodName method) {
        return isLookedInto(method) && library.rounds(method).isEmpty();
    }

    private boolean isEnd(AbstractInsnNode instruction) {
        return instruction instanceof MethodInsnNode call
                && code.targets(call).stream().noneMatch(this::returns)
                && !code.targets(call).isEmpty();
    }

    /** Whether a call ever comes back in the ordinary way. */
    private boolean returns(MethodName method) {
        if (library.isEnd(method)
                || library.isOfObjects(method) && sizes.containsKey(MonitorSize.TEXT)) {
            return false;
        }
        Boolean before = returning.get(method);
        if (before == null) {
            returning.put(method, true); // while it is looked at; what calls itself comes back
            before = code.method(method).map(this::hasReturn).orElse(true);
            returning.put(method, before);
        }
        return before;
    }

    private boolean hasReturn(MethodNode body) {
        boolean isNative = (body.access & (Opcodes.ACC_NATIVE | Opcodes.ACC_ABSTRACT)) != 0;
        FlowGraph graph = new FlowGraph(body);
        return isNative || !useful(graph).isEmpty();
    }

    /** An instruction's weight; a call's with what it calls. */
    final long of(AbstractInsnNode instruction) {
        long own = own(instruction);
        return instruction instanceof MethodInsnNode call
                ? own + within(call).heaviest(call) + (monitors.goesOn(call) ? violation(call) : 0)
                : own;
    }

    /** What a monitor does once, when something is violated and the robot goes on. */
    private long violation(MethodInsnNode call) {
        return RobotMonitors.OF_VIOLATION.stream().mapToLong(within(call)::of).sum();
    }

    private long heaviest(MethodInsnNode call) {
        long heaviest = 0;
        for (MethodName target : code.targets(call)) {
            heaviest = Math.max(heaviest, of(target));
        }
        return heaviest;
    }

    /** Who weighs what a call leads to: where a monitor is asked, who knows its sizes. */
    private MethodWeights within(MethodInsnNode call) {
        Optional<String> monitor = monitors.asked(call);
        return monitor.isEmpty()
                ? this
                : ofMonitors.computeIfAbsent(
                        monitor.get(),
                        each -> ofMonitor(monitors.alone(each), monitors.size(each).words()));
    }

    /** Whether a call is to be weighed at once, and not by the ways that it can go. */
    final boolean isWeighedAtOnce(MethodInsnNode call) {
        return monitors.asked(call).isPresent();
    }
}
