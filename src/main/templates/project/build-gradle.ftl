// 'gradle build' checks, verifies and tests the models, and makes <#if robot>a jar for the brick: build/nxt<#else>Java of them</#if>.
plugins {
    id 'arcomat' version '${version}'
}

repositories {
    mavenLocal() // where Arcomat's own build puts it, with ./gradlew publishToMavenLocal
    mavenCentral()
}
<#if robot>

arcomat {
    targets = ['jvm', 'lejos']
}
</#if>
