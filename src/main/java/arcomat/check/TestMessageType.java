package arcomat.check;

import arcomat.symbols.StreamTestSymbol;
import arcomat.symbols.StreamTestSymbol.StreamSymbol;
import arcomat.symbols.Typed;

/** ARC0703: the messages of a stream have the type of its port. */
final class TestMessageType implements Check.OnStreamTest {

    @Override
    public Law law() {
        return Law.error("ARC0703");
    }

    @Override
    public void check(StreamTestSymbol test, Context context, Findings findings) {
        for (StreamSymbol stream : test.streams()) {
            for (Typed message : stream.messages()) {
                if (!message.isAssignableTo(stream.type())) {
                    findings.report(
                            message.expression().node(),
                            "port '"
                                    + stream.node().port()
                                    + "' takes "
                                    + Wording.mismatch(stream.type(), message));
                }
            }
        }
    }
}
