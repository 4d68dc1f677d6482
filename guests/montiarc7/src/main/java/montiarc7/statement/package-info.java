/**
 * Expressions and statements: what they read, which values are known beforehand, and the text that
 * says the same.
 */
package montiarc7.statement;
