package arcomat.check.tests;

import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.StreamTestSymbol;
import arcomat.symbols.bodies.StreamTestSymbol.StreamSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.tree.QualifiedName;
import arcomat.tree.TestSuite;

import java.util.List;

/** ARC0702: a stream names a port of the tested component, in the block of its direction. */
public final class TestPortExists implements Check.OnStreamTest {

    @Override
    public void check(StreamTestSymbol test, Context context, Findings findings) {
        test.suite()
                .component()
                .found()
                .ifPresent(
                        component ->
                                test.streams()
                                        .forEach(stream -> check(stream, component, findings)));
    }

    private static void check(StreamSymbol stream, ComponentSymbol component, Findings findings) {
        if (stream.port().isUnknown()) {
            reportUnknown(stream, component, findings);
        } else if (stream.port().isFound() && stream.isDriven() != isDriving(stream)) {
            reportDirection(stream, stream.port().found().orElseThrow(), findings);
        }
    }

    private static boolean isDriving(StreamSymbol stream) {
        return stream.kind() != TestSuite.Kind.EXPECT;
    }

    private static void reportUnknown(
            StreamSymbol stream, ComponentSymbol component, Findings findings) {
        QualifiedName name = stream.node().port();
        List<String> candidates =
                component.ports().stream()
                        .filter(port -> port.isInput() == isDriving(stream))
                        .map(PortSymbol::name)
                        .toList();
        findings.reportUnknown(
                name.span(),
                "component '"
                        + component.name()
                        + "' has no "
                        + (isDriving(stream) ? "input" : "output")
                        + " port '"
                        + name
                        + "'",
                name.text(),
                candidates,
                candidates.isEmpty()
                        ? "remove the stream"
                        : "it has " + Wording.quoted(candidates));
    }

    private static void reportDirection(StreamSymbol stream, PortSymbol port, Findings findings) {
        QualifiedName name = stream.node().port();
        findings.report(
                        name,
                        stream.isDriven()
                                ? "the component receives on '"
                                        + name
                                        + "'; move the stream to the 'input' block"
                                : "the component sends on '"
                                        + name
                                        + "'; move the stream to the 'expect' block")
                .related(port.nameSpan(), "declared here");
    }
}
