package arcomat.syntax.layout;

import arcomat.syntax.antlr.ArcomatLexer;
import arcomat.syntax.antlr.ArcomatParser;

import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.tree.ParseTree;
import org.antlr.v4.runtime.tree.TerminalNode;
import org.jspecify.annotations.Nullable;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Set;

/** What the parse tree says of each token, by token index. */
final class Structure {
    private static final Set<Integer> STARTING_LINES =
            Set.of(
                    ArcomatParser.RULE_packageDeclaration,
                    ArcomatParser.RULE_importDeclaration,
                    ArcomatParser.RULE_component,
                    ArcomatParser.RULE_element,
                    ArcomatParser.RULE_automaton,
                    ArcomatParser.RULE_automatonElement,
                    ArcomatParser.RULE_ioTable,
                    ArcomatParser.RULE_tableInputs,
                    ArcomatParser.RULE_tableOutputs,
                    ArcomatParser.RULE_row,
                    ArcomatParser.RULE_classDiagram,
                    ArcomatParser.RULE_typeDefinition,
                    ArcomatParser.RULE_typeMember,
                    ArcomatParser.RULE_testSuite,
                    ArcomatParser.RULE_suiteMember,
                    ArcomatParser.RULE_testPart,
                    ArcomatParser.RULE_portStream,
                    ArcomatParser.RULE_eventStream);

    private static final Set<Integer> WITH_BODY =
            Set.of(
                    ArcomatParser.RULE_component,
                    ArcomatParser.RULE_automaton,
                    ArcomatParser.RULE_statements,
                    ArcomatParser.RULE_variation,
                    ArcomatParser.RULE_alternative,
                    ArcomatParser.RULE_ioTable,
                    ArcomatParser.RULE_implementation,
                    ArcomatParser.RULE_classDiagram,
                    ArcomatParser.RULE_testSuite);

    private static final Set<Integer> VERBATIM =
            Set.of(ArcomatParser.RULE_javaBlock, ArcomatParser.RULE_invariantBody);

    private final boolean[] startsLine;
    private final boolean[] opensBody;
    private final boolean[] closesBody;
    private final int[] indent;
    private final int[] verbatimEnd;
    private final ParserRuleContext[] parent;

    /** The list of ports that was entered last and takes a line for each. */
    private ArcomatParser.@Nullable PortsContext spreadPorts;

    private Structure(int tokens) {
        startsLine = new boolean[tokens];
        opensBody = new boolean[tokens];
        closesBody = new boolean[tokens];
        indent = new int[tokens];
        verbatimEnd = new int[tokens];
        parent = new ParserRuleContext[tokens];
    }

    static Structure of(ParserRuleContext root, int tokens) {
        Structure structure = new Structure(tokens);
        structure.visit(root, 0);
        return structure;
    }

    boolean startsLine(Token token) {
        return startsLine[token.getTokenIndex()];
    }

    boolean opensBody(Token token) {
        return opensBody[token.getTokenIndex()];
    }

    boolean closesBody(Token token) {
        return closesBody[token.getTokenIndex()];
    }

    /** In levels, for tokens that start a line. */
    int indent(Token token) {
        return indent[token.getTokenIndex()];
    }

    /** Index of the last token of foreign text that begins here, 0 if none does. */
    int verbatimEnd(Token token) {
        return verbatimEnd[token.getTokenIndex()];
    }

    /** The production that a token stands in directly. */
    ParserRuleContext parent(Token token) {
        return parent[token.getTokenIndex()];
    }

    int rule(Token token) {
        ParserRuleContext context = parent(token);
        return context == null ? -1 : context.getRuleIndex();
    }

    /** A row of operators is a tree that is deep on the left: that side is gone down in a loop. */
    private void visit(ParserRuleContext context, int level) {
        ParserRuleContext next = context;
        while (next instanceof ArcomatParser.BinaryExpressionContext row) {
            parent[row.operator.getTokenIndex()] = row;
            visit(row.expression(1), level);
            next = row.expression(0);
        }
        visitOne(next, level);
    }

    private void visitOne(ParserRuleContext context, int level) {
        if (STARTING_LINES.contains(context.getRuleIndex()) || isStatementOfItsOwn(context)) {
            markLine(context.start, level);
        } else if (context instanceof ArcomatParser.EnumConstantContext && isFirstOfBody(context)) {
            markLine(context.start, level);
        } else if (context instanceof ArcomatParser.PortContext
                && context.getParent() == spreadPorts) {
            markLine(context.start, level + 1);
        } else if (context instanceof ArcomatParser.PortsContext ports && isSpread(ports, level)) {
            spreadPorts = ports;
        }
        if (VERBATIM.contains(context.getRuleIndex())) {
            verbatimEnd[context.start.getTokenIndex()] = context.stop.getTokenIndex();
        }
        boolean body = hasBody(context);
        int inner = level;
        for (int i = 0; i < context.getChildCount(); i++) {
            ParseTree child = context.getChild(i);
            if (child instanceof ParserRuleContext node) {
                visit(node, inner);
            } else if (child instanceof TerminalNode leaf) {
                Token token = leaf.getSymbol();
                parent[token.getTokenIndex()] = context;
                if (body && token.getType() == ArcomatLexer.OPEN_BRACE) {
                    opensBody[token.getTokenIndex()] = true;
                    inner = level + 1;
                } else if (body && token.getType() == ArcomatLexer.CLOSE_BRACE) {
                    closesBody[token.getTokenIndex()] = true;
                    inner = level;
                    closeLine(context, i, token, level);
                }
            }
        }
    }

    /** A branch of a choice begins behind its condition. */
    private static boolean isStatementOfItsOwn(ParserRuleContext context) {
        return context.getRuleIndex() == ArcomatParser.RULE_statement
                && context.getParent() instanceof ArcomatParser.StatementsContext;
    }

    /** The brace of an empty body stays on the line, unless a comment lies in between. */
    private void closeLine(ParserRuleContext context, int child, Token brace, int level) {
        boolean empty =
                context.getChild(child - 1) instanceof TerminalNode open
                        && open.getSymbol().getTokenIndex() == brace.getTokenIndex() - 1;
        if (!empty) {
            markLine(brace, level);
        }
    }

    /**
     * Ports stand below each other where one line cannot hold them, or where they have comments.
     */
    private static boolean isSpread(ArcomatParser.PortsContext ports, int level) {
        List<TerminalNode> leaves = leaves(ports);
        boolean hasComments =
                ports.stop.getTokenIndex() - ports.start.getTokenIndex() >= leaves.size();
        int text = leaves.stream().mapToInt(leaf -> leaf.getText().length()).sum();
        int length = text + leaves.size() + 4 * level;
        return ports.port().size() > 1 && (hasComments || length > Wrapping.WIDTH);
    }

    /** Of an enum whose constants are not all that it holds. */
    private static boolean isFirstOfBody(ParserRuleContext constant) {
        ParserRuleContext parent = constant.getParent();
        return hasMembers(parent)
                && ((ArcomatParser.EnumDefinitionContext) parent).enumConstant(0) == constant;
    }

    private static boolean hasMembers(ParserRuleContext context) {
        return context instanceof ArcomatParser.EnumDefinitionContext definition
                && !definition.typeMember().isEmpty();
    }

    private static List<TerminalNode> leaves(ParseTree tree) {
        List<TerminalNode> leaves = new ArrayList<>();
        Deque<ParseTree> open = new ArrayDeque<>(List.of(tree));
        while (!open.isEmpty()) {
            ParseTree next = open.pop();
            if (next instanceof TerminalNode leaf) {
                leaves.add(leaf);
            }
            for (int i = 0; i < next.getChildCount(); i++) {
                open.push(next.getChild(i));
            }
        }
        return leaves;
    }

    private void markLine(Token token, int level) {
        startsLine[token.getTokenIndex()] = true;
        indent[token.getTokenIndex()] = level;
    }

    private static boolean hasBody(ParserRuleContext context) {
        return WITH_BODY.contains(context.getRuleIndex())
                || context.getRuleIndex() == ArcomatParser.RULE_typeBody
                || hasMembers(context)
                || context instanceof ArcomatParser.TestMemberContext
                || context instanceof ArcomatParser.StreamsPartContext
                || context instanceof ArcomatParser.EventsPartContext;
    }
}
