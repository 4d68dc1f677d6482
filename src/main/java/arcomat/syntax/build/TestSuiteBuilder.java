package arcomat.syntax.build;

import arcomat.syntax.antlr.ArcomatParser.BeforeContext;
import arcomat.syntax.antlr.ArcomatParser.BeforeMemberContext;
import arcomat.syntax.antlr.ArcomatParser.BeforePartContext;
import arcomat.syntax.antlr.ArcomatParser.EventStreamContext;
import arcomat.syntax.antlr.ArcomatParser.EventsPartContext;
import arcomat.syntax.antlr.ArcomatParser.FieldMemberContext;
import arcomat.syntax.antlr.ArcomatParser.PortStreamContext;
import arcomat.syntax.antlr.ArcomatParser.StreamsPartContext;
import arcomat.syntax.antlr.ArcomatParser.TestMemberContext;
import arcomat.syntax.antlr.ArcomatParser.TestPartContext;
import arcomat.syntax.antlr.ArcomatParser.TestSuiteContext;
import arcomat.tree.TestSuite;
import arcomat.tree.TestSuite.Before;
import arcomat.tree.TestSuite.Field;
import arcomat.tree.TestSuite.Kind;
import arcomat.tree.TestSuite.Member;
import arcomat.tree.TestSuite.PortStream;
import arcomat.tree.TestSuite.Streams;
import arcomat.tree.TestSuite.Test;

import java.util.ArrayList;
import java.util.List;

/** Suites of stream tests; the streams by {@link StreamBuilder}. */
final class TestSuiteBuilder extends TreeBuilder<Member> {
    private final Phrases phrases;
    private final StreamBuilder streamBuilder;

    TestSuiteBuilder(Phrases phrases, StreamBuilder streamBuilder) {
        super(phrases.texts);
        this.phrases = phrases;
        this.streamBuilder = streamBuilder;
    }

    TestSuite testSuite(TestSuiteContext context) {
        return new TestSuite(
                span(context),
                phrases.names.build(context.name()),
                phrases.qualifiedNames.build(context.qualifiedName()),
                phrases.expressions.arguments(context.arguments()),
                buildAll(context.suiteMember()));
    }

    @Override
    public Member visitTestMember(TestMemberContext context) {
        List<Streams> streams = new ArrayList<>();
        List<Before> before = new ArrayList<>();
        for (TestPartContext part : context.testPart()) {
            if (part instanceof StreamsPartContext block) {
                streams.add(streams(block));
            } else if (part instanceof EventsPartContext block) {
                streams.add(events(block));
            } else if (part instanceof BeforePartContext block) {
                before.add(before(block.before()));
            } else {
                throw new AssertionError(part);
            }
        }
        return new Test(span(context), phrases.names.build(context.name()), streams, before);
    }

    private Streams streams(StreamsPartContext context) {
        List<PortStream> streams = new ArrayList<>();
        for (PortStreamContext stream : context.portStream()) {
            streams.add(streamBuilder.portStream(stream));
        }
        Kind kind = context.kind.getText().equals("input") ? Kind.INPUT : Kind.EXPECT;
        return new Streams(span(context), kind, streams);
    }

    private Streams events(EventsPartContext context) {
        List<PortStream> streams = new ArrayList<>();
        for (EventStreamContext stream : context.eventStream()) {
            streams.add(streamBuilder.eventStream(stream));
        }
        return new Streams(span(context), Kind.EVENTS, streams);
    }

    @Override
    public Member visitBeforeMember(BeforeMemberContext context) {
        return before(context.before());
    }

    private Before before(BeforeContext context) {
        return new Before(
                span(context),
                phrases.names.build(context.name()),
                span(context.javaBlock()).text());
    }

    @Override
    public Member visitFieldMember(FieldMemberContext context) {
        return new Field(
                span(context),
                phrases.types.build(context.plainType()),
                phrases.variables.buildAll(context.variable()));
    }
}
