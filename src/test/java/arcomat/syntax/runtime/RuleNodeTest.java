package arcomat.syntax.runtime;

import static org.assertj.core.api.Assertions.assertThat;

import org.antlr.v4.runtime.CommonToken;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.tree.ErrorNodeImpl;
import org.antlr.v4.runtime.tree.ParseTree;
import org.antlr.v4.runtime.tree.TerminalNodeImpl;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;
import java.util.stream.IntStream;

/** A node answers as ANTLR's own does, however many children it has. */
class RuleNodeTest {
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 7})
    void answersAsAntlrDoes(int children) {
        RuleNode node = new RuleNode(null, 1);
        ParserRuleContext expected = new ParserRuleContext(null, 1);
        for (int i = 0; i < children; i++) {
            ParseTree child = i % 3 == 1 ? leaf(i) : new RuleNode(null, i);
            node.addAnyChild(child);
            expected.addAnyChild(child);
        }
        assertSame(node, expected);
        node.removeLastChild();
        if (children > 0) { // ANTLR's own fails where there is none in a list
            expected.removeLastChild();
        }
        assertSame(node, expected);
        node.addAnyChild(leaf(0));
        expected.addAnyChild(leaf(0));
        assertThat(node.getChildCount()).isEqualTo(expected.getChildCount());
    }

    private static void assertSame(RuleNode node, ParserRuleContext expected) {
        assertThat(children(node)).isEqualTo(children(expected));
        assertThat(node.getChild(-1)).isNull();
        assertThat(node.getChild(expected.getChildCount())).isNull();
        assertThat(node.<RuleNode>getRuleContexts(RuleNode.class))
                .isEqualTo(expected.<RuleNode>getRuleContexts(RuleNode.class));
        for (int i = -1; i < 4; i++) {
            assertThat(node.<RuleNode>getRuleContext(RuleNode.class, i))
                    .isEqualTo(expected.<RuleNode>getRuleContext(RuleNode.class, i));
            assertThat(node.getTokens(i)).isEqualTo(expected.getTokens(i));
            assertThat(node.getToken(1, i)).isEqualTo(expected.getToken(1, i));
        }
    }

    /** What a labelled alternative takes from its rule are the errors, and nothing else. */
    @Test
    void errorsMoveToTheLabelledAlternative() {
        RuleNode rule = new RuleNode(null, 1);
        ErrorNodeImpl error = new ErrorNodeImpl(new CommonToken(1));
        rule.addErrorNode(error);
        RuleNode alternative = new RuleNode();
        alternative.copyFrom(rule);
        assertThat(children(alternative)).isEqualTo(List.of(error));
        assertThat(error.getParent()).isSameAs(alternative);
        RuleNode fine = new RuleNode(null, 1);
        fine.addAnyChild(leaf(1));
        RuleNode empty = new RuleNode();
        empty.copyFrom(fine);
        assertThat(empty.getChildCount()).isZero();
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 5})
    void whatIsUnwantedGoes(int children) {
        RuleNode node = new RuleNode(null, 1);
        IntStream.range(0, children).forEach(i -> node.addAnyChild(leaf(i)));
        node.removeChildrenIf(child -> child.getText().equals("0"));
        assertThat(children(node)).hasSize(children - 1);
        node.removeChildrenIf(child -> true);
        assertThat(children(node)).isEmpty();
    }

    private static List<ParseTree> children(ParserRuleContext node) {
        return IntStream.range(0, node.getChildCount()).mapToObj(node::getChild).toList();
    }

    private static TerminalNodeImpl leaf(int number) {
        return new TerminalNodeImpl(new CommonToken(1, String.valueOf(number)));
    }
}
