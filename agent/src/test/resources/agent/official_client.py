"""What a program of the protocol's own library sees of 'arcomat mcp'; prints it, a line for each thing."""

import asyncio
import json
import sys

from mcp import ClientSession, StdioServerParameters
from mcp.client.stdio import stdio_client


def told(result):
    return [content.text for content in result.content]


async def main(arcomat, root):
    server = StdioServerParameters(command=arcomat, args=["mcp", root])
    async with stdio_client(server) as (reads, writes), ClientSession(reads, writes) as session:
        await session.initialize()
        tools = (await session.list_tools()).tools
        print("tools:", *sorted(tool.name for tool in tools))

        check = await session.call_tool("check", {})
        print("check:", json.loads(told(check)[0])["errors"], "errors")

        page = await session.call_tool("explain", {"code": "ARC0104"})
        print("explain:", told(page)[0].splitlines()[0])

        sides = {"left": "coffee.fig5.AvoidCrash", "right": "coffee.fig3.AvoidCrash"}
        holds = await session.call_tool("refines", sides)
        print("refines:", json.loads(told(holds)[0])["verdict"])
        fails = await session.call_tool("refines", sides | {"completion": "ignore,ignore"})
        verdict = json.loads(told(fails)[0])
        print("refines:", verdict["verdict"], "after", len(verdict["trace"]), "steps")

        run = await session.call_tool("simulate", {"component": "coffee.fetcher.Fetcher", "slices": 5})
        print("simulate:", len(json.loads(told(run)[0])["steps"]), "slices")

        suite = root + "/coffee/fig6/AvoidCrashTest.mt"
        tests = json.loads(told(await session.call_tool("test", {"paths": [suite]}))[0])["tests"]
        print("test:", {test["verdict"] for test in tests})

        picture = await session.call_tool("diagram", {"components": ["coffee.fig6.AvoidCrash"]})
        print("diagram:", told(picture)[0][:4])

        world = await session.call_tool("world", {"world": root + "/world/meeting.world"})
        print("world:", json.loads(told(world)[0])["succeeded"])

        everything = await session.call_tool("test", {})
        text, answer, part = told(everything)[0], None, 1
        remark = told(everything)[1]
        while "Call the tool 'rest'" in remark:
            answer = answer or int(remark.split("answer ")[1].split(" ")[0])
            part += 1
            rest = await session.call_tool("rest", {"answer": answer, "part": part})
            text += told(rest)[0]
            remark = told(rest)[1]
        print("in parts:", part > 1, len(json.loads(text)["tests"]) > 30)

        outside = await session.call_tool("check", {"paths": ["/etc/passwd"]})
        print("outside:", json.loads(told(outside)[0])["findings"][0]["message"])
        wrong = await session.call_tool("simulate", {"slices": "many"})
        print("wrong:", told(wrong)[0])


asyncio.run(main(*sys.argv[1:]))
