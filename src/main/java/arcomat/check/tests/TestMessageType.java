package arcomat.check.tests;

import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.StreamTestSymbol;
import arcomat.symbols.bodies.StreamTestSymbol.StreamSymbol;
import arcomat.symbols.expressions.Typed;

/** ARC0703: the messages of a stream have the type of its port. */
public final class TestMessageType implements Check.OnStreamTest {

    @Override
    public void check(StreamTestSymbol test, Context context, Findings findings) {
        for (StreamSymbol stream : test.streams()) {
            for (Typed message : stream.messages()) {
                if (!message.isAssignableTo(stream.type())) {
                    findings.report(
                            message.expression().node(),
                            "port '%s' takes %s",
                            stream.node().port(),
                            Wording.mismatch(stream.type(), message));
                }
            }
        }
    }
}
