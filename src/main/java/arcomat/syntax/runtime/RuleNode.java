package arcomat.syntax.runtime;

import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.tree.ErrorNode;
import org.antlr.v4.runtime.tree.ParseTree;
import org.antlr.v4.runtime.tree.TerminalNode;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.IntStream;

/**
 * A node of the parse tree, for each context that the parser makes. Most have one child, for which
 * ANTLR's own class keeps a list with room for ten; here the first child needs none.
 */
public class RuleNode extends ParserRuleContext {
    /** The sole child; null if there is none, or if {@link #children} has them all. */
    private @Nullable ParseTree onlyChild;

    /** As the generated contexts of labelled alternatives call it. */
    protected RuleNode() {}

    protected RuleNode(@Nullable ParserRuleContext parent, int invokingState) {
        super(parent, invokingState);
    }

    /** A labelled alternative takes the place of its rule, and with it the errors found so far. */
    @Override
    public void copyFrom(ParserRuleContext context) {
        super.copyFrom(context);
        if (context instanceof RuleNode node && node.onlyChild instanceof ErrorNode error) {
            addChild(error);
        }
    }

    @Override
    public <T extends ParseTree> T addAnyChild(T child) {
        if (children != null) {
            children.add(child);
        } else if (onlyChild == null) {
            onlyChild = child;
        } else {
            children = new ArrayList<>(4);
            children.add(onlyChild);
            children.add(child);
            onlyChild = null;
        }
        return child;
    }

    @Override
    public void removeLastChild() {
        onlyChild = null;
        super.removeLastChild();
    }

    /** Takes children out of the tree, however many. */
    public final void removeChildrenIf(Predicate<ParseTree> unwanted) {
        if (children != null) {
            children.removeIf(unwanted);
        } else if (onlyChild != null && unwanted.test(onlyChild)) {
            onlyChild = null;
        }
    }

    @Override
    public int getChildCount() {
        if (children != null) {
            return children.size();
        }
        return onlyChild == null ? 0 : 1;
    }

    @Override
    public @Nullable ParseTree getChild(int index) {
        if (children != null) {
            return index >= 0 && index < children.size() ? children.get(index) : null;
        }
        return index == 0 ? onlyChild : null;
    }

    @Override
    public <T extends ParseTree> @Nullable T getChild(Class<? extends T> type, int index) {
        int before = 0;
        for (int i = 0; i < getChildCount(); i++) {
            ParseTree child = getChild(i);
            if (type.isInstance(child) && before++ == index) {
                return type.cast(child);
            }
        }
        return null;
    }

    @Override
    public @Nullable TerminalNode getToken(int type, int index) {
        List<TerminalNode> tokens = getTokens(type);
        return index >= 0 && index < tokens.size() ? tokens.get(index) : null;
    }

    @Override
    public List<TerminalNode> getTokens(int type) {
        return IntStream.range(0, getChildCount())
                .mapToObj(this::getChild)
                .filter(TerminalNode.class::isInstance)
                .map(TerminalNode.class::cast)
                .filter(leaf -> leaf.getSymbol().getType() == type)
                .toList();
    }

    @Override
    public <T extends ParserRuleContext> List<T> getRuleContexts(Class<? extends T> type) {
        int count = 0;
        for (int i = 0; i < getChildCount(); i++) {
            count += type.isInstance(getChild(i)) ? 1 : 0;
        }
        return count == 0 ? List.of() : contexts(type, count);
    }

    private <T extends ParserRuleContext> List<T> contexts(Class<? extends T> type, int count) {
        List<T> contexts = new ArrayList<>(count);
        for (int i = 0; i < getChildCount(); i++) {
            if (type.isInstance(getChild(i))) {
                contexts.add(type.cast(getChild(i)));
            }
        }
        return contexts;
    }
}
