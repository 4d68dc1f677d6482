/*
 * Suites of stream tests.
 */
grammar StreamTest;

import Expression;

testSuiteUnit
    : header testSuite EOF
    ;

testSuite
    : 'testsuite' name 'for' qualifiedName componentArguments? '{' suiteMember* '}'
    ;

suiteMember
    : 'test' name '{' testPart* '}'                                         # testMember
    | before                                                                # beforeMember
    | plainType variable (',' variable)* ';'                                # fieldMember
    ;

testPart
    : kind = ('input' | 'expect') '{' portStream* '}'                       # streamsPart
    | 'events' '{' eventStream* '}'                                         # eventsPart
    | before                                                                # beforePart
    ;

before
    : '@' name javaBlock
    ;

portStream
    : qualifiedPlace ':' stream ';'
    ;

eventStream
    : qualifiedPlace ':' (stream | streamElement) ';'
    ;

stream
    : '<' (streamElement (',' streamElement)*)? '>'
    ;

// Not expressions: ">" closes the stream.
streamElement
    : message                                                               # singleMessage
    | count = INT '*' message                                               # repeatedMessage
    | count = INT '*' '(' streamElement (',' streamElement)* ')'            # repeatedGroup
    | '(' streamElement (',' streamElement)* ')'                            # singleGroup
    ;

message
    : minus = '-'? literal                                                  # literalMessage
    | minus = '-'? qualifiedName arguments?                                 # nameMessage
    ;
