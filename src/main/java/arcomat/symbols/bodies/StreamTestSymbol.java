package arcomat.symbols.bodies;

import arcomat.symbols.expressions.ExpressionTyping;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.names.Lazy;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnknownType;
import arcomat.tree.Name;
import arcomat.tree.TestSuite;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** One stream test: its streams with resolved ports and typed messages. */
public final class StreamTestSymbol {
    /**
     * A stream for a port of the component, or by instance path for a port of a platform component
     * inside it.
     *
     * @param port unknown if there is no such port or it is none that a test reaches; of either
     *     direction, see {@link #isDriven}
     */
    public record StreamSymbol(
            TestSuite.PortStream node,
            TestSuite.Kind kind,
            Resolution<PortSymbol> port,
            List<Typed> messages,
            StreamExtent extent) {
        /** Whether the port takes messages from the test: then it belongs under input. */
        public boolean isDriven() {
            return port.found().filter(p -> p.isInput() == node.port().isSimple()).isPresent();
        }

        /** The type of its messages; unknown where the port is. */
        public TypeSymbol type() {
            return port.found().<TypeSymbol>map(PortSymbol::type).orElse(UnknownType.UNKNOWN);
        }
    }

    private final TestSuiteSymbol suite;
    private final TestSuite.Test node;
    private final Lazy<List<StreamSymbol>> streams = new Lazy<>(this::makeStreams);

    StreamTestSymbol(TestSuiteSymbol suite, TestSuite.Test node) {
        this.suite = suite;
        this.node = node;
    }

    public TestSuiteSymbol suite() {
        return suite;
    }

    public TestSuite.Test node() {
        return node;
    }

    public String name() {
        return node.name().text();
    }

    /** All streams of all blocks in text order. */
    public List<StreamSymbol> streams() {
        return streams.get();
    }

    /**
     * How much there is to lay out in memory, slices and messages of all streams together; see
     * {@link StreamExtent#LIMIT}.
     */
    public long extent() {
        return StreamExtent.sum(streams().stream().map(StreamSymbol::extent)).total();
    }

    public boolean isTooLong() {
        return extent() > StreamExtent.LIMIT;
    }

    private List<StreamSymbol> makeStreams() {
        List<StreamSymbol> all = new ArrayList<>();
        for (TestSuite.Streams block : node.streams()) {
            for (TestSuite.PortStream stream : block.streams()) {
                all.add(stream(block.kind(), stream));
            }
        }
        return List.copyOf(all);
    }

    private StreamSymbol stream(TestSuite.Kind kind, TestSuite.PortStream node) {
        Resolution<PortSymbol> port = port(node);
        TypeSymbol expected =
                port.found().<TypeSymbol>map(PortSymbol::type).orElse(UnknownType.UNKNOWN);
        List<Typed> messages = new ArrayList<>();
        for (TestSuite.StreamElement element : TestSuite.StreamElement.written(node.elements())) {
            if (element instanceof TestSuite.Message message) {
                messages.add(message(message, expected));
            }
        }
        return new StreamSymbol(node, kind, port, messages, StreamExtent.of(node.elements()));
    }

    private Typed message(TestSuite.Message message, TypeSymbol expected) {
        Typed typed =
                ExpressionTyping.message(message.expression(), suite.scope(expected), expected);
        return expected.isErroneous() ? typed.withoutUnknownNames() : typed;
    }

    private Resolution<PortSymbol> port(TestSuite.PortStream stream) {
        Optional<ComponentSymbol> component = suite.component().found();
        if (component.isEmpty()) {
            return Resolution.excused();
        }
        List<Name> parts = stream.port().parts();
        return InstancePath.port(component.get(), parts.stream().map(Name::text).toList());
    }
}
