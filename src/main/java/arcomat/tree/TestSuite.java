package arcomat.tree;

import arcomat.source.Span;

import java.util.List;

/** {@code testsuite Name for Component(args) {..}}. */
public record TestSuite(
        Span span,
        Name name,
        QualifiedName component,
        List<Expression> arguments,
        List<Member> members)
        implements Definition {
    public TestSuite {
        arguments = List.copyOf(arguments);
        members = List.copyOf(members);
    }

    public sealed interface Member extends Node {}

    public record Test(Span span, Name name, List<Streams> streams, List<Before> before)
            implements Member {
        public Test {
            streams = List.copyOf(streams);
            before = List.copyOf(before);
        }
    }

    /** A field of 2012 suites: kept, reported. */
    public record Field(Span span, TypeReference type, List<Variable> variables) implements Member {
        public Field {
            variables = List.copyOf(variables);
        }
    }

    /** {@code @Before {..}} of 2012 suites: kept, reported. */
    public record Before(Span span, Name name, String text) implements Member {}

    /** One {@code input}, {@code expect} or {@code events} block. */
    public record Streams(Span span, Kind kind, List<PortStream> streams) implements Node {
        public Streams {
            streams = List.copyOf(streams);
        }
    }

    public enum Kind {
        INPUT,
        EXPECT,
        EVENTS
    }

    public record PortStream(Span span, QualifiedName port, List<StreamElement> elements)
            implements Node {
        public PortStream {
            elements = List.copyOf(elements);
        }
    }

    public sealed interface StreamElement extends Node {}

    /** {@code Tk}: the end of a time slice. */
    public record Tick(Span span) implements StreamElement {}

    public record Message(Span span, Expression expression) implements StreamElement {}

    /** {@code n*x} and {@code n*(x, y)}. */
    public record Repeat(Span span, int count, List<StreamElement> elements)
            implements StreamElement {
        public Repeat {
            elements = List.copyOf(elements);
        }
    }
}
