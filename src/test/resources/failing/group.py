# says: ValueError: in a group
import asyncio
async def main():
    async with asyncio.TaskGroup() as tg:
        tg.create_task(f()); 
async def f(): raise ValueError("in a group")
asyncio.run(main())
