package arcomat.syntax.build;

import arcomat.syntax.antlr.ArcomatParser;
import arcomat.tree.TestSuite;
import arcomat.tree.TestSuite.Before;
import arcomat.tree.TestSuite.Field;
import arcomat.tree.TestSuite.Kind;
import arcomat.tree.TestSuite.Member;
import arcomat.tree.TestSuite.Streams;
import arcomat.tree.TestSuite.Test;

import java.util.ArrayList;
import java.util.List;

/** Suites of stream tests; the streams by {@link StreamBuilder}. */
final class TestSuiteBuilder extends TreeBuilder<Member> {
    private final StreamBuilder streams;

    TestSuiteBuilder(Phrases phrases) {
        super(phrases);
        this.streams = new StreamBuilder(phrases);
    }

    TestSuite testSuite(ArcomatParser.TestSuiteContext context) {
        return new TestSuite(
                span(context),
                phrases.name(context.name()),
                phrases.qualifiedName(context.qualifiedName()),
                phrases.expressions.given(context.componentArguments()),
                buildAll(context.suiteMember()));
    }

    @Override
    public Member visitTestMember(ArcomatParser.TestMemberContext context) {
        List<Streams> blocks = new ArrayList<>();
        List<Before> before = new ArrayList<>();
        for (ArcomatParser.TestPartContext part : context.testPart()) {
            if (part instanceof ArcomatParser.BeforePartContext block) {
                before.add(before(block.before()));
            } else {
                blocks.add(streams(part));
            }
        }
        return new Test(
                span(context),
                phrases.name(context.name()),
                List.copyOf(blocks),
                List.copyOf(before));
    }

    private Streams streams(ArcomatParser.TestPartContext context) {
        if (context instanceof ArcomatParser.EventsPartContext events) {
            return new Streams(
                    span(context), Kind.EVENTS, each(events.eventStream(), streams::eventStream));
        }
        var block = (ArcomatParser.StreamsPartContext) context;
        Kind kind = block.kind.getText().equals("input") ? Kind.INPUT : Kind.EXPECT;
        return new Streams(span(context), kind, each(block.portStream(), streams::portStream));
    }

    @Override
    public Member visitBeforeMember(ArcomatParser.BeforeMemberContext context) {
        return before(context.before());
    }

    private Before before(ArcomatParser.BeforeContext context) {
        return new Before(
                span(context), phrases.name(context.name()), phrases.text(context.javaBlock()));
    }

    @Override
    public Member visitFieldMember(ArcomatParser.FieldMemberContext context) {
        return new Field(
                span(context),
                phrases.type(context.plainType()),
                phrases.variables(context.variable()));
    }
}
