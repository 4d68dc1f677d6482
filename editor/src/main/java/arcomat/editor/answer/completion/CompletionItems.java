package arcomat.editor.answer.completion;

import org.eclipse.lsp4j.CompletionItem;
import org.eclipse.lsp4j.CompletionItemKind;
import org.eclipse.lsp4j.InsertTextFormat;

/** Proposals as the protocol has them. */
final class CompletionItems {
    private CompletionItems() {}

    /** For the picture that editors put before it. */
    static CompletionItemKind kind(Proposal.Kind kind) {
        return switch (kind) {
            case COMPONENT -> CompletionItemKind.Class;
            case PART -> CompletionItemKind.Module;
            case PORT -> CompletionItemKind.Interface;
            case VARIABLE -> CompletionItemKind.Variable;
            case STATE, CONSTANT -> CompletionItemKind.EnumMember;
            case FEATURE -> CompletionItemKind.Property;
            case TYPE -> CompletionItemKind.Enum;
            case BUILTIN_TYPE -> CompletionItemKind.Struct;
            case TRUTH -> CompletionItemKind.Constant;
        };
    }

    /** A piece, behind names and words. */
    static CompletionItem piece(Skeleton skeleton) {
        CompletionItem item = new CompletionItem(skeleton.label());
        item.setKind(CompletionItemKind.Snippet);
        item.setDetail(skeleton.detail());
        item.setInsertTextFormat(InsertTextFormat.Snippet);
        item.setInsertText(skeleton.text());
        item.setSortText("3" + skeleton.label());
        return item;
    }
}
